#include "engine/control/reaction_wheels.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "engine/control/bounded_least_squares.h"
#include "engine/math/symmetric_algebra.h"

namespace netpocket {

ReactionWheels::ReactionWheels(const std::vector<ReactionWheel>& wheels)
    : wheels_(wheels),
      axes_(3, static_cast<Eigen::Index>(wheels.size())),
      momenta_(wheels.size(), 0.0),
      torques_(wheels.size(), 0.0) {
  if (wheels.empty()) throw std::invalid_argument("there must be at least one reaction wheel");
  for (std::size_t i = 0; i < wheels.size(); ++i) {
    const double length = symmetric_norm(wheels[i].axis);
    if (!(length > 0 && std::isfinite(length))) throw std::invalid_argument("a reaction wheel needs an axis");
    if (!(wheels[i].most_torque > 0 && wheels[i].most_momentum > 0))
      throw std::invalid_argument("a reaction wheel needs positive limits of torque and momentum");
    axes_.col(static_cast<Eigen::Index>(i)) = wheels[i].axis / length;
  }
}

void ReactionWheels::command(const Eigen::Vector3d& wanted) {
  Eigen::VectorXd lower(axes_.cols()), upper(axes_.cols());
  for (Eigen::Index i = 0; i < axes_.cols(); ++i) {
    const ReactionWheel& wheel = wheels_[i];
    lower[i] = momenta_[i] <= -wheel.most_momentum ? 0 : -wheel.most_torque;
    upper[i] = momenta_[i] >= wheel.most_momentum ? 0 : wheel.most_torque;
  }
  const Eigen::VectorXd torques = bounded_least_squares(axes_, -wanted, lower, upper);
  for (Eigen::Index i = 0; i < axes_.cols(); ++i) torques_[i] = torques[i];
}

Wrench ReactionWheels::step(const Eigen::Vector3d& angular_velocity, double dt) {
  const Eigen::Vector3d before = momentum();
  for (std::size_t i = 0; i < wheels_.size(); ++i) {
    const double most = wheels_[i].most_momentum;
    momenta_[i] = std::clamp(momenta_[i] + torques_[i] * dt, -most, most);
  }
  const Eigen::Vector3d after = momentum();
  return {Eigen::Vector3d::Zero(), (before - after) / dt - angular_velocity.cross(0.5 * (before + after))};
}

double ReactionWheels::load() const {
  double load = 0;
  for (std::size_t i = 0; i < wheels_.size(); ++i) {
    const bool is_full = std::abs(momenta_[i]) >= wheels_[i].most_momentum;
    load = std::max(load, is_full ? 1 : std::abs(torques_[i]) / wheels_[i].most_torque);
  }
  return load;
}

Eigen::Vector3d ReactionWheels::momentum() const {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < momenta_.size(); ++i) sum += momenta_[i] * axes_.col(static_cast<Eigen::Index>(i));
  return sum;
}

void ReactionWheels::visit_state(const NumberVisitor& visit) {
  visit_numbers(visit, momenta_);
  visit_numbers(visit, torques_);
}

}  // namespace netpocket
