#pragma once
// The seam between a run and what controls it. Before each step a controller gets measurements and gives commands. It
// does not know the run that it belongs to, and any number of controllers may act side by side (control_loop.h).
//
// World frame, SI units. Thread contract: the thread of the run.

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "engine/dynamics/system/cable_system.h"
#include "engine/scenario/scenario.h"

namespace netpocket {

// The state of a system at the beginning of a step, and what was exerted in the step before. A view of the system,
// valid until the system steps. `body` and `rope` are indices into Model::bodies and Model::ropes.
class Measurements {
 public:
  explicit Measurements(const CableSystem& system) : system_(&system) {}

  double time() const { return system_->time(); }  // s
  // Centre of mass and attitude of the body by itself.
  BodyState body(std::int32_t body) const { return system_->body(body); }
  // Motion of the common centre of mass of a body and what is attached to it.
  RigidMotion motion(std::int32_t body) const { return system_->motion(body); }
  // What the controls of a body exerted in the last step, about that centre.
  const Wrench& exerted(std::int32_t body) const { return system_->exerted(body); }
  // Whether a lock holds a body.
  bool is_held(std::int32_t body) const { return system_->is_held(body); }
  const RopeMotion& rope(std::int32_t rope) const { return system_->rope_motion(rope); }
  Eigen::Vector3d node(std::int32_t node) const { return system_->position(node); }  // m
  // Impulse (N s) that cables have given to a body since the start.
  const Eigen::Vector3d& contact_impulse(std::int32_t body) const { return system_->contact_impulse(body); }
  // Mean tension (N) of a rope.
  double rope_tension(std::int32_t rope) const { return system_->rope_tension(rope); }
  // Of the first ropes (N, by rope).
  void rope_tensions(std::span<double> tensions) const { system_->rope_tensions(tensions); }

 private:
  const CableSystem* system_;
};

// What a controller asks for during the next step. The control of a body holds until the controller is asked again. All
// other commands act once.
class Commands {
 public:
  // `bodies`, `ropes`: numbers of bodies and ropes of the model.
  Commands(std::size_t bodies, std::size_t ropes) : bodies_(bodies), ropes_(ropes) {}

  // The control of a body. The first call in a step begins with no force and no prescribed motion.
  BodyControl& body(std::int32_t body);
  // Motion of a rope at the end of the step. A rope that nobody winds keeps its rate and acceleration.
  void wind(std::int32_t rope, const RopeMotion& at_end) { ropes_[static_cast<std::size_t>(rope)] = at_end; }
  void set_friction(double coefficient) { friction_ = coefficient; }
  // Releases a body that is locked to another.
  void release(std::int32_t body) { released_.push_back(body); }
  // Wrinkling moment (N m) of the rods of a material.
  void set_wrinkling_moment(std::int32_t material, double moment) { moments_.emplace_back(material, moment); }

  void clear();
  // Adds those of another controller, and takes from it those that act once. Wrenches add up. Where both prescribe a
  // motion, set the friction or wind a rope, `other` rules.
  void take(Commands& other, const Measurements& measurements);
  // Gives the commands to a system.
  void apply(CableSystem& system) const;

  // Gives every number of the commands for bodies to `visit`, which may change it.
  void visit_state(const std::function<void(double&)>& visit);

 private:
  std::vector<std::optional<BodyControl>> bodies_;
  std::vector<std::optional<RopeMotion>> ropes_;
  std::optional<double> friction_;
  std::vector<std::pair<std::int32_t, double>> moments_;  // material, N m
  std::vector<std::int32_t> released_;                    // bodies
};

class Controller {
 public:
  virtual ~Controller() = default;

  // Commands for the coming `interval` (s): the next step or, for a sampled controller, its period.
  virtual void update(const Measurements& measurements, double interval, Commands& commands) = 0;
  // Called after each step of `dt` (s).
  virtual void after_step(const Measurements& /*measurements*/, double /*dt*/) {}
  // Adopts the strategy of another scenario at the time `now` (s). No force and no motion may jump.
  virtual void change(const Scenario& /*scenario*/, double /*now*/) {}

  // Shortest length (m) to which this controller winds a rope until a time (s); infinite if it does not know. The
  // choice of the step uses it.
  virtual double shortest_length(std::int32_t /*rope*/, double /*now*/, double /*until*/) const {
    return std::numeric_limits<double>::infinity();
  }
  // What this controller did that may explain why a run diverged, and the remedy; empty: nothing. Part of a sentence.
  virtual std::string suspicion() const { return {}; }

  // Gives every number of the state to `visit`, always in the same order. `visit` may change the number.
  virtual void visit_state(const std::function<void(double&)>& visit) = 0;
};

}  // namespace netpocket
