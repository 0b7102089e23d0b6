#pragma once
// An ideal actuator of a body: exerts any force and torque within limits by component, with a first-order lag.
// Propellant is counted as if a thruster acted along each axis: mass flow = (|F_x| + |F_y| + |F_z|)/(Isp g0). Torque
// costs none.

#include <Eigen/Core>
#include <limits>

#include "engine/control/first_order_lag.h"
#include "engine/control/visited_numbers.h"
#include "engine/dynamics/assembly/dynamic_body.h"

namespace netpocket {

struct WrenchBoxSettings {
  // Largest size of each component, body axes.
  Eigen::Vector3d most_force = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());   // N
  Eigen::Vector3d most_torque = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());  // N m
  double time_constant = 0;                                                                          // s; 0: no lag
  double specific_impulse = 220;                                                                     // s, positive
};

class WrenchBox {
 public:
  explicit WrenchBox(const WrenchBoxSettings& settings);

  // Commands the wanted wrench (body axes, about the centre of mass) until the next command.
  void command(const Wrench& wanted);
  // The mean wrench (body axes, about the centre of mass) over the next `dt` (s).
  Wrench step(double dt);

  double propellant() const { return propellant_; }  // kg consumed so far
  // Largest part of the limit of a component in the last command; more than 1: it was cut. 0 without limits.
  double force_load() const { return force_load_; }
  double torque_load() const { return torque_load_; }
  void visit_state(const NumberVisitor& visit);

 private:
  WrenchBoxSettings settings_;
  FirstOrderLag lag_;
  Wrench commanded_;       // within the limits
  Wrench exerted_;         // at the end of the last step
  double propellant_ = 0;  // kg
  double force_load_ = 0, torque_load_ = 0;
};

}  // namespace netpocket
