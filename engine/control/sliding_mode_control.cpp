#include "engine/control/sliding_mode_control.h"

#include <Eigen/LU>

namespace netpocket {

AttitudeSlidingMode::AttitudeSlidingMode(const SlidingModeGains& gains, double observer_bandwidth,
                                         const Eigen::Matrix3d& inertia)
    : law_(gains, observer_bandwidth), inertia_(inertia), inverse_inertia_(inertia.inverse()) {}

Wrench AttitudeSlidingMode::update(const BodyState& present, const WantedMotion& wanted, const Eigen::Vector3d& contact,
                                   double dt) {
  const Eigen::Vector3d spin = to_body_axes(present, present.angular_velocity);
  const Eigen::Vector3d gyroscopic = spin.cross(inertia_ * spin);
  const Eigen::Vector3d impact = to_body_axes(present, contact);
  const Eigen::Vector3d known = inverse_inertia_ * (acting_ + impact - gyroscopic);
  const Eigen::Vector3d feedback = law_.update(rotation_error(present, wanted.state), spin, known, dt);
  acting_ = inertia_ * (to_body_axes(present, wanted.angular_acceleration) + feedback) + gyroscopic - impact;
  return {Eigen::Vector3d::Zero(), to_world_axes(present, acting_)};
}

void AttitudeSlidingMode::visit_state(const NumberVisitor& visit) {
  law_.visit_state(visit);
  visit_numbers(visit, acting_);
}

PositionSlidingMode::PositionSlidingMode(const SlidingModeGains& gains, double observer_bandwidth, double mass)
    : law_(gains, observer_bandwidth), mass_(mass) {}

Wrench PositionSlidingMode::update(const BodyState& present, const WantedMotion& wanted, const Eigen::Vector3d& contact,
                                   double dt) {
  const Eigen::Vector3d known = (acting_ + contact) / mass_;
  const Eigen::Vector3d feedback = law_.update(position_error(present, wanted.state), present.velocity, known, dt);
  acting_ = mass_ * (wanted.acceleration + feedback) - contact;
  return {acting_, Eigen::Vector3d::Zero()};
}

void PositionSlidingMode::visit_state(const NumberVisitor& visit) {
  law_.visit_state(visit);
  visit_numbers(visit, acting_);
}

}  // namespace netpocket
