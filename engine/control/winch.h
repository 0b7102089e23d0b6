#pragma once
// A winch: a drum with a motor and a brake that winds a rope in and pays it out.
//
// With the drum's radius r and moment of inertia J, the length L of rope outside, its tension T, the motor's torque
// (positive winds in) and the force B of the brake:
//   (J/r^2) L'' = T - torque/r - B.
// Stepped by symplectic Euler, as a rope at its end is. The brake is dry friction up to its torque; it holds a drum
// that stands exactly.
//
// The motor is commanded one of four quantities. Length and tension give a wanted rate, and a PI loop turns the error
// of the rate into torque, within the limit:
//   length   rate = L_w' - K_L (L - L_w)
//   tension  rate = K_T (T - T_w) + D_T T', and at least the take-up rate inwards while the rope is slack
//   torque/r = P (L' - rate) + I int (L' - rate) dt
// The loop acts at every step dt. For a slack rope it is stable if P dt < 2 J/r^2.
//
// Energy: the motor's work and the rope's work on the drum go into the drum's kinetic energy and into the losses of the
// brake and of stops. Each is summed by its own law, with the mean rate of a step.

#include <cstdint>
#include <limits>

#include "engine/control/pid.h"
#include "engine/control/visited_numbers.h"
#include "engine/model/model.h"

namespace netpocket {

struct WinchSettings {
  double drum_radius = 0.05;      // r, m, positive
  double drum_inertia = 0.01;     // J, kg m^2, of all that turns, referred to the drum; positive
  double most_torque = 10;        // N m, of the motor at the drum
  double brake_torque = 100;      // N m
  double fastest = 1;             // m/s, largest wanted rate
  double least_length = 0.1;      // m, of rope outside; the drum stops there
  double rate_gain = 100;         // P, N s/m
  double rate_integral = 0;       // I, N/m
  double length_gain = 1;         // K_L, 1/s
  double tension_gain = 0.01;     // K_T, m/(N s)
  double tension_derivative = 0;  // D_T, m/N
  double slack_tension = 0;       // N, a rope with no more is slack
  double take_up_rate = 0;        // m/s
  // N: the drum's clutch transmits no more of the motor's and the brake's force to the rope.
  double slip_tension = std::numeric_limits<double>::infinity();
  // m, of rope outside when the drum is empty; it stops there.
  double most_length = std::numeric_limits<double>::infinity();
};

enum class WinchMode : std::uint8_t { torque, rate, length, tension };

struct WinchCommand {
  WinchMode mode = WinchMode::rate;
  double value = 0;    // N m, m/s, m or N, by mode
  double rate = 0;     // m/s, L_w' in the mode length
  bool brake = false;  // engaged; the motor then rests
  double most_brake = std::numeric_limits<double>::infinity();  // N, of the brake on the rope: a light brake drags
};

class Winch {
 public:
  // `length`: of rope outside at the start, m. The drum is at rest. Throws std::invalid_argument unless the settings
  // are as described above and the length is no less than the least one.
  Winch(const WinchSettings& settings, double length);

  void command(const WinchCommand& command) { command_ = command; }
  // A fault: the drum stops at once and stays until the jam ends.
  void jam(bool jammed) { jammed_ = jammed; }

  // Steps over `dt` (s) with the rope's tension (N). Returns the motion at the end. `measured`: the tension (N) that
  // the motor's loop knows.
  const RopeMotion& step(double tension, double dt) { return step(tension, tension, dt); }
  const RopeMotion& step(double tension, double measured, double dt);

  const RopeMotion& motion() const { return motion_; }
  double torque() const { return force_ * settings_.drum_radius; }  // N m, of the motor in the last step
  double power() const { return power_; }                           // W, of the motor in the last step
  double motor_work() const { return motor_work_; }                 // J, so far
  double rope_work() const { return rope_work_; }                   // J, of the rope on the drum so far
  double losses() const { return losses_; }                         // J, of the brake and of stops so far
  double kinetic_energy() const;                                    // J, of the drum

  void visit_state(const NumberVisitor& visit);

 private:
  double wanted_rate(double tension, double tension_rate) const;
  double motor_force(double tension, double dt);
  double stopped_rate(double rate, double dt) const;

  WinchSettings settings_;
  double mass_;  // J/r^2, kg
  WinchCommand command_;
  bool jammed_ = false;
  RopeMotion motion_;
  Pid rate_loop_;
  bool started_ = false;
  double last_tension_ = 0;  // N, measured
  double force_ = 0;         // N, motor's torque / r
  double power_ = 0;
  double motor_work_ = 0, rope_work_ = 0, losses_ = 0;
};

}  // namespace netpocket
