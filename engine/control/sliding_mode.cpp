#include "engine/control/sliding_mode.h"

#include <algorithm>

namespace netpocket {

double saturation(double x, double width) {
  if (x == 0) return 0;
  return width > 0 ? std::clamp(x / width, -1.0, 1.0) : (x > 0 ? 1 : -1);
}

Eigen::Vector3d saturation(const Eigen::Vector3d& x, double width) {
  return {saturation(x.x(), width), saturation(x.y(), width), saturation(x.z(), width)};
}

Eigen::Vector3d reaching_law(const SlidingModeGains& gains, const Eigen::Vector3d& s) {
  return -gains.reaching * s - gains.switching * saturation(s, gains.layer);
}

SlidingModeLaw::SlidingModeLaw(const SlidingModeGains& gains, double observer_bandwidth) : gains_(gains) {
  if (observer_bandwidth > 0) observer_.emplace(observer_bandwidth);
}

Eigen::Vector3d SlidingModeLaw::update(const TrackingError& error, const Eigen::Vector3d& velocity,
                                       const Eigen::Vector3d& known, double dt) {
  if (observer_) observer_->update(velocity, known, dt);
  return reaching_law(gains_, sliding_variable(error)) - gains_.slope * error.rate - disturbance();
}

Eigen::Vector3d SlidingModeLaw::disturbance() const {
  return observer_ ? observer_->disturbance() : Eigen::Vector3d::Zero();
}

void SlidingModeLaw::visit_state(const NumberVisitor& visit) {
  if (observer_) observer_->visit_state(visit);
}

}  // namespace netpocket
