#include "engine/control/wrench_box.h"

#include <algorithm>
#include <cmath>

#include "engine/control/thrusters.h"

namespace netpocket {
namespace {

// A limit of 0 is exceeded by any demand.
double largest_part(const Eigen::Vector3d& wanted, const Eigen::Vector3d& most) {
  double part = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double size = std::abs(wanted[axis]);
    if (size > 0) part = std::max(part, most[axis] > 0 ? size / most[axis] : 1.0);
  }
  return part;
}

}  // namespace

WrenchBox::WrenchBox(const WrenchBoxSettings& settings) : settings_(settings), lag_(settings.time_constant) {}

void WrenchBox::command(const Wrench& wanted) {
  force_load_ = largest_part(wanted.force, settings_.most_force);
  torque_load_ = largest_part(wanted.torque, settings_.most_torque);
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
  for (double* number : {&propellant_, &force_load_, &torque_load_}) visit(*number);
}

}  // namespace netpocket
