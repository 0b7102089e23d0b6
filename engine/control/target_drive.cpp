#include "engine/control/target_drive.h"

#include "engine/control/tracking_error.h"

namespace netpocket {

void TargetDrive::update(const Measurements& measurements, double /*interval*/, Commands& commands) {
  if (target_.thrust == Eigen::Vector3d::Zero() && target_.torque == Eigen::Vector3d::Zero()) return;
  const double now = measurements.time();
  if (now < target_.acts_from || now >= target_.acts_until) return;
  const BodyState state = measurements.body(body_);
  commands.body(body_).at_centre = {to_world_axes(state, target_.thrust), to_world_axes(state, target_.torque)};
}

void TargetDrive::change(const Scenario& scenario, double /*now*/) { target_ = scenario.target; }

void TargetDrive::visit_state(const std::function<void(double&)>& /*visit*/) {}

}  // namespace netpocket
