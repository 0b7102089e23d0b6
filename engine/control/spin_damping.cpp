#include "engine/control/spin_damping.h"

#include "engine/math/symmetric_algebra.h"

namespace netpocket {

Wrench SpinDamping::demand(const Eigen::Vector3d& angular_velocity) const {
  Wrench demand;
  demand.torque = -gain * (angular_velocity - wanted_spin);
  const double size = symmetric_norm(demand.torque);
  if (size > most) demand.torque *= most / size;
  return demand;
}

}  // namespace netpocket
