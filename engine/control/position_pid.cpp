#include "engine/control/position_pid.h"

namespace netpocket {

PositionPid::PositionPid(const std::array<PidSettings, 3>& axes, double mass)
    : axes_{Pid(axes[0]), Pid(axes[1]), Pid(axes[2])}, mass_(mass) {}

Wrench PositionPid::update(const BodyState& present, const WantedMotion& wanted, double dt) {
  const TrackingError error = position_error(present, wanted.state);
  Wrench demand;
  for (int axis = 0; axis < 3; ++axis) {
    demand.force[axis] = axes_[axis].update(error.error[axis], error.rate[axis], dt, mass_ * wanted.acceleration[axis]);
  }
  return demand;
}

void PositionPid::visit_state(const NumberVisitor& visit) {
  for (Pid& axis : axes_) axis.visit_state(visit);
}

}  // namespace netpocket
