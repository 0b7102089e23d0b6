#include "engine/control/attitude_pd.h"

namespace netpocket {

AttitudeGains attitude_gains(const Eigen::Vector3d& moments, double frequency, double damping_ratio) {
  return {frequency * frequency * moments, 2 * damping_ratio * frequency * moments};
}

Wrench AttitudePd::demand(const BodyState& present, const WantedMotion& wanted) const {
  const TrackingError error = rotation_error(present, wanted.state);
  const Eigen::Vector3d spin = to_body_axes(present, present.angular_velocity);
  const Eigen::Vector3d acceleration = to_body_axes(present, wanted.angular_acceleration);
  const Eigen::Vector3d feedback =
      gains_.proportional.cwiseProduct(error.error) + gains_.derivative.cwiseProduct(error.rate);
  const Eigen::Vector3d torque = spin.cross(inertia_ * spin) + inertia_ * acceleration - feedback;
  return {Eigen::Vector3d::Zero(), to_world_axes(present, torque)};
}

}  // namespace netpocket
