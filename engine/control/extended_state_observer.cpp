#include "engine/control/extended_state_observer.h"

namespace netpocket {

void ExtendedStateObserver::update(const Eigen::Vector3d& velocity, const Eigen::Vector3d& known, double dt) {
  if (!started_) {
    started_ = true;
    velocity_ = velocity;
    return;
  }
  const double pole = decay_.over(dt);
  const Eigen::Vector3d predicted = velocity_ + dt * (known + disturbance_);
  const Eigen::Vector3d miss = velocity - predicted;
  velocity_ = predicted + (1 - pole * pole) * miss;
  disturbance_ += (1 - pole) * (1 - pole) / dt * miss;
}

void ExtendedStateObserver::visit_state(const NumberVisitor& visit) {
  visit_flag(visit, started_);
  visit_numbers(visit, velocity_);
  visit_numbers(visit, disturbance_);
}

}  // namespace netpocket
