#pragma once
// Steps a capture in time. Owns the complete state of the run.
// Thread contract: one thread at a time; nothing is shared with other objects. `advance` may use several threads
// inside. The result is bitwise the same for any number of threads.

#include <functional>
#include <memory>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "engine/dynamics/system/cable_system.h"
#include "engine/scenario/scenario.h"
#include "engine/state/run_status.h"
#include "engine/state/snapshot.h"
#include "engine/state/structure.h"

namespace netpocket {

class Controller;  // control/controller.h

struct SimulationOptions {
  int threads = 1;
};

class Simulation {
 public:
  // The scenario must be valid: check_scenario reports no errors.
  explicit Simulation(const Scenario& scenario, const SimulationOptions& options = {});
  ~Simulation();
  Simulation(Simulation&&) noexcept;
  Simulation& operator=(Simulation&&) noexcept;

  const Scenario& scenario() const;
  const Structure& structure() const;
  double time() const;  // s
  // Which events of the scenario have not come up to now, as a part of a sentence; empty: none.
  std::string awaited() const;

  // Steps to `until` (s), or until `stop` is requested or the run diverges. On divergence the state is set back to the
  // last sound one. The status then says which step failed, and which cable, contact or body. Steps do not depend on
  // how calls of advance divide the time: an output interval is a whole number of steps.
  RunStatus advance(double until, const std::stop_token& stop = {});
  // The same for a number of steps, however long they are.
  RunStatus advance_steps(std::int64_t count, const std::stop_token& stop = {});

  // Adds a controller to those of the capture system, from now on. It rules where both wind a rope or prescribe a
  // motion. `period` (s) between its samples; 0: asked before every step. Its state becomes part of checkpoints. What
  // it throws leaves advance(), at a whole step.
  void add_controller(std::unique_ptr<Controller> controller, double period = 0);

  // The present state. Channels that are averages (contact force) are means since the previous call.
  Snapshot snapshot();

  // Applies the strategy of another scenario from now on: closing, towing, station keeping, contact friction, the rods'
  // pressure, disturbances and the end time. Each changes gradually, without jumps (closing_transition.h, towing.h,
  // material_changes.h). Returns the keys of all other parameters that differ. These are not applied: they need a new
  // Simulation.
  std::vector<std::string> change_strategy(const Scenario& scenario);

  // Saves and restores the complete state as numbers. To be restored into a Simulation of the same scenario(), which
  // includes the strategy now in force. It then continues bitwise as the original did. Throws std::invalid_argument
  // when the size does not fit or the state is not sound.
  std::vector<double> checkpoint() const;
  void restore(std::span<const double> state);

  // Whether one sector of the system stands for all at present (solver.symmetry).
  SymmetryStatus symmetry() const;
  RunStatistics statistics() const;  // wall and CPU seconds are those spent in advance()

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

// The status of a run that has reached its end time. Says which events never came.
RunStatus finished_run(const Simulation& simulation);

}  // namespace netpocket
