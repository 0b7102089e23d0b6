#pragma once
// The control laws of a scenario's controllers behind one interface: known state in, demanded wrench out.

#include <memory>

#include "engine/control/observed.h"
#include "engine/dynamics/assembly/dynamic_body.h"
#include "engine/scenario/control_parameters.h"

namespace netpocket {

// What a law knows of the spacecraft. The pocket's inertia is left to the feedback: it is flexible.
struct ControlledCraft {
  Eigen::Matrix3d inertia;   // kg m^2, of the spacecraft about its centre of mass, body axes
  double mass = 0;           // kg, of the spacecraft with the pocket
  double captured_mass = 0;  // kg, with the target too
  Eigen::Vector3d position;  // m, of the centre of mass at the start
};

// What a law controls: its set point, the value, and by how much that is off. A scalar is the first component.
struct Tracking {
  Eigen::Vector3d set_point = Eigen::Vector3d::Zero();
  Eigen::Vector3d actual = Eigen::Vector3d::Zero();
  Eigen::Vector3d error = Eigen::Vector3d::Zero();
};

class ControlLaw {
 public:
  virtual ~ControlLaw() = default;

  // Demanded wrench about the centre of mass (world axes) from `time` (s) on, after another period `dt` (s).
  virtual Wrench update(const Observed& observed, double time, double dt) = 0;
  // What the actuators exerted on average since the last update, world axes.
  virtual void note_delivered(const BodyState& /*craft*/, const Wrench& /*exerted*/) {}
  // Of a true state at `time` (s). Attitude: rotation vectors (rad), the error in body axes. Position (m) and angular
  // velocity (rad/s): world axes. Tow: speed (m/s) or separation (m).
  virtual Tracking tracking(const BodyState& craft, const BodyState& target, double time) const = 0;
  // Estimated disturbance: force in world axes, torque in body axes.
  virtual Wrench disturbance() const { return {}; }
  // To be called when parameters have changed: a ramp begins anew.
  virtual void restart() {}
  // The number of numbers depends on the kind and on whether there is an observer.
  virtual void visit_state(const NumberVisitor& /*visit*/) {}
};

std::unique_ptr<ControlLaw> control_law(const ControllerParameters& controller, const ControlledCraft& craft);

}  // namespace netpocket
