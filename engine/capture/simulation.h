#pragma once
// Steps a capture in time. Owns the whole state.
// Thread contract: one thread at a time; nothing is shared with other objects. `advance` may use several threads
// inside; the result is the same for any number, to the last bit.

#include <functional>
#include <memory>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "engine/scenario/scenario.h"
#include "engine/state/run_status.h"
#include "engine/state/snapshot.h"
#include "engine/state/structure.h"

namespace netpocket {

struct SimulationOptions {
  int threads = 1;
};

class Simulation {
 public:
  // The scenario must be valid (see check_scenario).
  explicit Simulation(const Scenario& scenario, const SimulationOptions& options = {});
  ~Simulation();
  Simulation(Simulation&&) noexcept;
  Simulation& operator=(Simulation&&) noexcept;

  const Scenario& scenario() const;
  const Structure& structure() const;
  double time() const;  // s

  // Steps to `until` (s) or until stopped or diverged. When it diverges the state is the last sound one, and the status
  // says which step led to which cable's, contact's or body's failure from there. Step boundaries do not depend on
  // `until`'s subdivision into output frames: frames are a whole number of steps.
  RunStatus advance(double until, const std::stop_token& stop = {});

  // The state now. Averages in its channels (contact force) run since the previous call.
  Snapshot snapshot();

  // Lets the strategy of another scenario act from now on: closing, towing, station keeping, contact friction, the
  // rods' pressure and the end time. Each goes over from what is so that nothing jumps (closing_transition.h, towing.h,
  // material_changes.h). Returns the keys of parameters that differ besides these: they need a new Simulation.
  std::vector<std::string> change_strategy(const Scenario& scenario);

  // The complete state as numbers, and back: a Simulation of the present scenario(), which holds the strategy that acts
  // now, continues from it to the last bit. Throws std::invalid_argument when the size does not fit or the state is not
  // sound.
  std::vector<double> checkpoint() const;
  void restore(std::span<const double> state);

  RunStatistics statistics() const;  // wall and cpu seconds are those spent in advance()

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace netpocket
