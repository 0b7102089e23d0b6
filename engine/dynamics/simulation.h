#pragma once
// Steps a capture in time. Owns the whole state.
// Thread contract: one thread at a time; nothing is shared with other objects. `advance` may use several threads
// inside; the result is the same for any number, to the last bit.

#include <functional>
#include <memory>
#include <stop_token>

#include "engine/recording/run_status.h"
#include "engine/recording/snapshot.h"
#include "engine/recording/structure.h"
#include "engine/scenario/scenario.h"

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

  // Steps to `until` (s) or until stopped or diverged. Step boundaries do not depend on `until`'s subdivision into
  // output frames: frames are a whole number of steps.
  RunStatus advance(double until, const std::stop_token& stop = {});

  // The state now. Averages in its channels (contact force) run since the previous call.
  Snapshot snapshot();

  RunStatistics statistics() const;  // wall and cpu seconds are those spent in advance()

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace netpocket
