#pragma once
// What a scenario says about closed-loop control: controllers, sensors, actuators and winches. Plain data in SI units;
// control_table.cpp declares every member once more. engine/THEORY.md section 11 has the equations.

#include <Eigen/Core>
#include <vector>

namespace netpocket {

enum class ControllerKind {
  attitude_pd,
  attitude_sliding_mode,
  attitude_double_loop,
  position_pd,
  position_sliding_mode,
  tow,
  spin_damping
};
enum class ControlPhase { always, open, closing, closed, towing, off };
enum class ControlledAxes { all, lateral, axial };
enum class TowQuantity { speed, separation };

// A controller of the spacecraft. Each kind uses some of the members.
struct ControllerParameters {
  ControllerKind kind = ControllerKind::attitude_pd;
  ControlPhase phase = ControlPhase::always;  // in which it acts; off: it never acts
  double rate = 100;                          // Hz, of its samples
  // Set points of attitude and position.
  Eigen::Vector3d attitude = {0, 0, 0};       // rad, rotation vector from world to body axes
  Eigen::Vector3d position = {0, 0, 0};       // m, of the centre of mass, from its place at the start
  Eigen::Vector3d velocity = {0, 0, 0};       // m/s, with which `position` moves
  ControlledAxes axes = ControlledAxes::all;  // of the position
  // PD.
  double frequency = 0.5;    // rad/s, natural frequency
  double damping_ratio = 1;  //
  // Sliding mode; the double loop's inner loop has all but the slope. Units for attitude, position.
  double slope = 0.5;       // 1/s
  double reaching = 0.5;    // 1/s
  double switching = 1e-3;  // rad/s^2, m/s^2
  double layer = 1e-3;      // rad/s, m/s
  double observer = 0;      // rad/s, bandwidth; 0: no observer
  bool feed_forward = false;
  // Outer loop of the double loop.
  double outer_switching = 0;  // rad/s
  double outer_layer = 0.01;   // rad
  double fastest = 0.1;        // rad/s
  // Tow.
  TowQuantity quantity = TowQuantity::speed;
  double wanted = 0.1;         // m/s, m
  double ramp = 4;             // s, over which the quantity goes to the wanted value
  double proportional = 2000;  // N per unit of the quantity
  double integral = 0;         // N/s per unit
  double derivative = 0;       // N s per unit
  double most_tension = 0;     // N; 0: no cap
  // Spin damping.
  double damping = 1000;     // N m s/rad
  double most_torque = 1e4;  // N m

  friend bool operator==(const ControllerParameters&, const ControllerParameters&) = default;
};

enum class SensorKind {
  attitude,
  angular_velocity,
  position,
  velocity,
  target_position,
  target_velocity,
  contact_force,
  rope_tension
};

// What controllers know of a quantity. A quantity without sensor is known exactly.
struct SensorParameters {
  SensorKind kind = SensorKind::attitude;
  double rate = 100;                 // Hz
  double noise = 0;                  // standard deviation of each component, in the quantity's unit
  Eigen::Vector3d bias = {0, 0, 0};  // in the quantity's unit
  double delay = 0;                  // s
  double dropout = 0;                // probability that a sample is lost
  int seed = 1;

  friend bool operator==(const SensorParameters&, const SensorParameters&) = default;
};

enum class ActuatorKind { ideal, box, thrusters };

struct ActuatorParameters {
  ActuatorKind kind = ActuatorKind::ideal;
  Eigen::Vector3d most_force = {100, 100, 100};  // N, body axes, of the box
  Eigen::Vector3d most_torque = {50, 50, 50};    // N m, body axes, of the box
  double time_constant = 0;                      // s, of the box and of valves; 0: no lag
  double impulse_bit = 0;                        // N s, least impulse of a thruster
  double specific_impulse = 220;                 // s

  friend bool operator==(const ActuatorParameters&, const ActuatorParameters&) = default;
};

struct ThrusterParameters {
  Eigen::Vector3d position = {0, 0, 0};   // m, body axes, from the centre of mass
  Eigen::Vector3d direction = {0, 1, 0};  // of the force on the body, body axes
  double thrust = 10;                     // N

  friend bool operator==(const ThrusterParameters&, const ThrusterParameters&) = default;
};

struct WheelParameters {
  Eigen::Vector3d axis = {0, 1, 0};  // body axes
  double most_torque = 1;            // N m
  double most_momentum = 50;         // N m s

  friend bool operator==(const WheelParameters&, const WheelParameters&) = default;
};

enum class DeflationStart { never, time, closing, closed };

// Gas that is let out of the rods.
struct DeflationParameters {
  DeflationStart starts_at = DeflationStart::never;
  double start = 0;        // s, or s after the closing starts or ends
  double rate = 50e3;      // Pa/s
  double pressure = 10e3;  // Pa, that stays

  friend bool operator==(const DeflationParameters&, const DeflationParameters&) = default;
};

enum class WinchDrive { prescribed, length, rate, tension, torque };

// Winches of the closing ropes, all alike.
struct WinchParameters {
  WinchDrive drive = WinchDrive::prescribed;
  double rate = 0.5;                    // m/s, at which rope is wound in
  double tension = 20;                  // N, to be kept
  double torque = 1;                    // N m
  double drum_radius = 0.05;            // m
  double drum_inertia = 0.01;           // kg m^2
  double most_torque = 10;              // N m
  double brake_torque = 100;            // N m
  double fastest = 2;                   // m/s
  double rate_gain = 400;               // N s/m
  double rate_integral = 800;           // N/m
  double length_gain = 4;               // 1/s
  double tension_gain = 0.01;           // m/(N s)
  double tension_derivative = 0;        // m/N
  double take_up_rate = 0.2;            // m/s
  std::vector<Eigen::Vector2d> late;    // (rope, s by which it starts after the others)
  std::vector<Eigen::Vector2d> jammed;  // (rope, s at which its retractor jams)

  friend bool operator==(const WinchParameters&, const WinchParameters&) = default;
};

enum class DisturbedBody { spacecraft, target };

// A force and a torque that act on a body for a while. The axes are those of the body.
struct DisturbanceParameters {
  DisturbedBody body = DisturbedBody::spacecraft;
  Eigen::Vector3d force = {0, 0, 0};   // N, through the centre of mass
  Eigen::Vector3d torque = {0, 0, 0};  // N m
  double start = 0;                    // s
  double duration = 1;                 // s

  friend bool operator==(const DisturbanceParameters&, const DisturbanceParameters&) = default;
};

}  // namespace netpocket
