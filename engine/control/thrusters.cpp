#include "engine/control/thrusters.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "engine/control/bounded_least_squares.h"
#include "engine/math/symmetric_algebra.h"

namespace netpocket {
namespace {

Thruster checked(Thruster thruster) {
  const double length = symmetric_norm(thruster.direction);
  if (!(length > 0 && std::isfinite(length))) throw std::invalid_argument("a thruster needs a direction");
  if (!thruster.position.allFinite()) throw std::invalid_argument("a thruster needs a position");
  if (!(thruster.thrust > 0 && std::isfinite(thruster.thrust)))
    throw std::invalid_argument("a thruster needs a positive thrust");
  if (!(thruster.impulse_bit >= 0 && std::isfinite(thruster.impulse_bit)))
    throw std::invalid_argument("the least impulse bit of a thruster must not be negative");
  if (!(thruster.specific_impulse > 0)) throw std::invalid_argument("a thruster needs a positive specific impulse");
  thruster.direction /= length;
  return thruster;
}

Eigen::Vector3d torque_of(const Thruster& thruster) { return thruster.position.cross(thruster.direction); }

// Root mean square of the lever arms, m; 1 if there are none.
double lever_of(const std::vector<Thruster>& thrusters) {
  double sum = 0;
  for (const Thruster& thruster : thrusters) sum += symmetric_squared_norm(torque_of(thruster));
  return sum > 0 ? std::sqrt(sum / static_cast<double>(thrusters.size())) : 1;
}

}  // namespace

Thrusters::Thrusters(const std::vector<Thruster>& thrusters, double time_constant)
    : effects_(6, static_cast<Eigen::Index>(thrusters.size())),
      lag_(time_constant),
      pulses_(thrusters.size(), 0.0),
      thrust_(thrusters.size(), 0.0) {
  if (thrusters.empty()) throw std::invalid_argument("there must be at least one thruster");
  for (const Thruster& thruster : thrusters) thrusters_.push_back(checked(thruster));
  lever_ = lever_of(thrusters_);
  for (std::size_t i = 0; i < thrusters_.size(); ++i) {
    effects_.col(static_cast<Eigen::Index>(i)) << thrusters_[i].direction, torque_of(thrusters_[i]) / lever_;
  }
}

void Thrusters::command(const Wrench& wanted, double period) {
  Eigen::VectorXd impulse(6), most(effects_.cols());
  impulse << period * wanted.force, period / lever_ * wanted.torque;
  for (Eigen::Index i = 0; i < most.size(); ++i) most[i] = period * thrusters_[i].thrust;
  const Eigen::VectorXd pulses = bounded_least_squares(effects_, impulse, Eigen::VectorXd::Zero(most.size()), most);
  load_ = 0;
  for (std::size_t i = 0; i < pulses_.size(); ++i) {
    const double bit = thrusters_[i].impulse_bit, pulse = pulses[static_cast<Eigen::Index>(i)];
    load_ = std::max(load_, pulse / most[static_cast<Eigen::Index>(i)]);
    const double fired = pulse < 0.5 * bit ? 0 : std::max(pulse, bit);
    pulses_[i] = std::max(fired, pulses_[i]);  // what is left of the last pulse goes on
  }
}

Wrench Thrusters::step(double dt) {
  Wrench wrench;
  for (std::size_t i = 0; i < thrusters_.size(); ++i) {
    const Thruster& thruster = thrusters_[i];
    const double given = std::min(pulses_[i], thruster.thrust * dt);
    pulses_[i] -= given;
    const double mean = lag_.step(thrust_[i], given / dt, dt);
    propellant_ += mean * dt / (thruster.specific_impulse * kStandardGravity);
    wrench += {mean * thruster.direction, mean * torque_of(thruster)};
  }
  return wrench;
}

void Thrusters::visit_state(const NumberVisitor& visit) {
  visit_numbers(visit, pulses_);
  visit_numbers(visit, thrust_);
  visit(propellant_);
  visit(load_);
}

}  // namespace netpocket
