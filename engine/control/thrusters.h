#pragma once
// Thrusters of a body: which of them fire for a wanted wrench, and what they exert and consume.
//
// A command is for one control period. The wanted impulse (wrench times period) is allocated by bounded least squares
// (bounded_least_squares.h) to impulses from 0 to the largest one of each thruster, with torques divided by the root
// mean square of the thrusters' lever arms. A thruster fires at full thrust from the start of the period until its
// impulse is given (pulse-width modulation). It cannot give less than its least impulse bit: less than half of it is
// not fired, more is rounded up to it, even if the pulse then outlasts the period. Valves follow with a first-order
// lag.
//
// A double integrator under bits of the impulse B with the lever L and the moment of inertia I ends in a limit cycle
// between the limits of the dead band, with the rate B L/(2 I) (Brown, Elements of Spacecraft Design (2002), section on
// limit cycles without external torque).
//
// Propellant: mass flow = thrust/(Isp g0), g0 = 9.80665 m/s^2.

#include <Eigen/Core>
#include <vector>

#include "engine/control/first_order_lag.h"
#include "engine/control/visited_numbers.h"
#include "engine/dynamics/assembly/dynamic_body.h"

namespace netpocket {

inline constexpr double kStandardGravity = 9.80665;  // m/s^2

struct Thruster {
  Eigen::Vector3d position;       // m, body axes, from the centre of mass
  Eigen::Vector3d direction;      // of the force on the body, body axes; any length but 0
  double thrust = 0;              // N, positive
  double impulse_bit = 0;         // N s, least impulse of a pulse; 0: any
  double specific_impulse = 220;  // s, positive
};

class Thrusters {
 public:
  // `time_constant` of the valves in s. Throws std::invalid_argument unless the thrusters are as described above.
  Thrusters(const std::vector<Thruster>& thrusters, double time_constant);

  // Commands the wanted wrench (body axes, about the centre of mass) for the next `period` (s).
  void command(const Wrench& wanted, double period);
  // The mean wrench (body axes, about the centre of mass) over the next `dt` (s).
  Wrench step(double dt);

  double propellant() const { return propellant_; }              // kg consumed so far
  double load() const { return load_; }                          // largest part of full thrust in the last command
  const std::vector<double>& pulses() const { return pulses_; }  // N s, left to be commanded to each valve

  void visit_state(const NumberVisitor& visit);

 private:
  std::vector<Thruster> thrusters_;
  Eigen::MatrixXd effects_;  // column: wrench of a unit thrust, torques divided by the lever
  double lever_;             // m
  FirstOrderLag lag_;
  std::vector<double> pulses_;  // N s
  std::vector<double> thrust_;  // N, behind the lag
  double propellant_ = 0;       // kg
  double load_ = 0;
};

}  // namespace netpocket
