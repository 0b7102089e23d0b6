#include "engine/control/wrench_box.h"

#include "engine/control/thrusters.h"

namespace netpocket {

WrenchBox::WrenchBox(const WrenchBoxSettings& settings) : settings_(settings), lag_(settings.time_constant) {}

void WrenchBox::command(const Wrench& wanted) {
  commanded_.force = wanted.force.cwiseMin(settings_.most_force).cwiseMax(-settings_.most_force);
  commanded_.torque = wanted.torque.cwiseMin(settings_.most_torque).cwiseMax(-settings_.most_torque);
}

Wrench WrenchBox::step(double dt) {
  Wrench mean;
  for (int axis = 0; axis < 3; ++axis) {
    mean.force[axis] = lag_.step(exerted_.force[axis], commanded_.force[axis], dt);
    mean.torque[axis] = lag_.step(exerted_.torque[axis], commanded_.torque[axis], dt);
  }
  const Eigen::Vector3d size = mean.force.cwiseAbs();
  propellant_ += dt * ((size.x() + size.z()) + size.y()) / (settings_.specific_impulse * kStandardGravity);
  return mean;
}

void WrenchBox::visit_state(const NumberVisitor& visit) {
  for (Wrench* wrench : {&commanded_, &exerted_}) {
    visit_numbers(visit, wrench->force);
    visit_numbers(visit, wrench->torque);
  }
  visit(propellant_);
}

}  // namespace netpocket
