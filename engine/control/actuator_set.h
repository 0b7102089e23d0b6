#pragma once
// The actuators of a spacecraft as a scenario describes them: an ideal or limited box of forces and torques or
// thrusters, and reaction wheels. Wheels, if there are any, take all torque that is demanded; their gyroscopic torque
// is compensated.

#include <optional>

#include "engine/control/reaction_wheels.h"
#include "engine/control/thrusters.h"
#include "engine/control/wrench_box.h"
#include "engine/scenario/scenario.h"

namespace netpocket {

class ActuatorSet {
 public:
  // The scenario must pass check_scenario.
  explicit ActuatorSet(const Scenario& scenario);

  // Commands a wrench (body axes, about the centre of mass) for the next `period` (s). `angular_velocity` in rad/s,
  // body axes.
  void command(const Wrench& wanted, const Eigen::Vector3d& angular_velocity, double period);
  // The mean wrench (body axes, about the centre of mass) over the next `dt` (s).
  Wrench step(const Eigen::Vector3d& angular_velocity, double dt);

  // Part of the limits that the last command asked for; 1 or more: saturated. 0 without limits.
  bool limits_force() const { return limits_force_; }
  bool limits_torque() const { return limits_torque_; }
  double force_load() const { return box_ ? box_->force_load() : thrusters_->load(); }
  double torque_load() const;
  double propellant() const;                   // kg consumed so far
  const std::vector<double>& momenta() const;  // N m s, of the wheels
  void visit_state(const NumberVisitor& visit);

 private:
  std::optional<WrenchBox> box_;  // or thrusters_
  std::optional<Thrusters> thrusters_;
  std::optional<ReactionWheels> wheels_;
  bool limits_force_, limits_torque_;
};

}  // namespace netpocket
