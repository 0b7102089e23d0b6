#pragma once
// A simulation as Python holds it. Only one thread at a time may use it: a second one gets an error instead of a crash.

#include <atomic>
#include <memory>
#include <span>

#include "engine/capture/simulation.h"
#include "engine/python/python_controller.h"
#include "engine/python/single_use.h"

namespace netpocket::python {

class PythonSimulation {
 public:
  // Throws ScenarioFault unless the scenario can be simulated.
  PythonSimulation(const Scenario& scenario, int threads);

  double time();
  const Scenario& scenario() const { return scenario_; }
  // Without the interpreter lock. Throws RunDiverged, and error_already_set after Ctrl-C.
  void advance(double until);
  void step(std::int64_t count);
  std::shared_ptr<Snapshot> snapshot();
  std::shared_ptr<Structure> structure();
  RunStatistics statistics();
  std::vector<double> checkpoint();
  void restore(std::span<const double> state);
  std::vector<std::string> change_strategy(const Scenario& scenario);
  void add_controller(const py::object& controller, double rate);
  // What a script commands between calls of advance().
  PythonCommands& held();

  std::int32_t body_index(const py::object& body);

 private:
  friend void advance_all(const std::vector<PythonSimulation*>& simulations, const std::vector<double>& until,
                          int threads);
  SingleUse use() { return {busy_, "simulation"}; }

  Scenario scenario_;
  std::unique_ptr<Simulation> simulation_;
  std::shared_ptr<Structure> structure_;
  PythonController* script_ = nullptr;  // owned by simulation_; null: not yet used
  std::atomic<bool> busy_ = false;
};

// Advances many simulations side by side, each to its time (s). Throws the first error after all have returned.
void advance_all(const std::vector<PythonSimulation*>& simulations, const std::vector<double>& until, int threads);

}  // namespace netpocket::python
