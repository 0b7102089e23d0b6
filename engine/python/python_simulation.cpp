#include "engine/python/python_simulation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <stdexcept>
#include <thread>

#include "engine/scenario/check_scenario.h"

namespace netpocket::python {
namespace {

// Simulated time (s) between two looks at signals such as Ctrl-C. It takes some 10 ms.
constexpr double kPart = 0.1;

const Scenario& checked(const Scenario& scenario) {
  const Diagnostics problems = check_scenario(scenario);
  if (!problems.ok()) throw ScenarioFault{problems};
  return scenario;
}

void demand(const RunStatus& status) {
  if (status.reason == RunReason::diverged) throw RunDiverged{status};
}

void look_at_signals() {
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
}

}  // namespace

PythonSimulation::PythonSimulation(const Scenario& scenario, int threads)
    : scenario_(checked(scenario)), simulation_(std::make_unique<Simulation>(scenario, SimulationOptions{threads})) {}

double PythonSimulation::time() {
  const SingleUse used = use();
  return simulation_->time();
}

void PythonSimulation::advance(double until) {
  if (!std::isfinite(until)) throw std::invalid_argument("the time to advance to must be finite");
  const SingleUse used = use();
  const double begin = simulation_->time();
  const int parts = std::max(1, static_cast<int>(std::ceil((until - begin) / kPart)));
  for (int part = 1; part <= parts; ++part) {
    const double to = part == parts ? until : begin + part * kPart;
    {
      const py::gil_scoped_release unlocked;
      demand(simulation_->advance(to));
    }
    look_at_signals();
  }
}

void PythonSimulation::step(std::int64_t count) {
  if (count < 0) throw std::invalid_argument("a number of steps cannot be negative");
  const SingleUse used = use();
  constexpr std::int64_t kSteps = 256;
  while (count > 0) {
    const std::int64_t part = std::min(count, kSteps);
    {
      const py::gil_scoped_release unlocked;
      demand(simulation_->advance_steps(part));
    }
    count -= part;
    look_at_signals();
  }
}

std::shared_ptr<Snapshot> PythonSimulation::snapshot() {
  const SingleUse used = use();
  return std::make_shared<Snapshot>(simulation_->snapshot());
}

std::shared_ptr<Structure> PythonSimulation::structure() {
  if (!structure_) structure_ = std::make_shared<Structure>(simulation_->structure());
  return structure_;
}

RunStatistics PythonSimulation::statistics() {
  const SingleUse used = use();
  return simulation_->statistics();
}

std::vector<double> PythonSimulation::checkpoint() {
  const SingleUse used = use();
  return simulation_->checkpoint();
}

void PythonSimulation::restore(std::span<const double> state) {
  const SingleUse used = use();
  simulation_->restore(state);
}

std::vector<std::string> PythonSimulation::change_strategy(const Scenario& scenario) {
  checked(scenario);
  const SingleUse used = use();
  const std::vector<std::string> others = simulation_->change_strategy(scenario);
  scenario_ = simulation_->scenario();
  return others;
}

void PythonSimulation::add_controller(const py::object& controller, double rate) {
  if (!(rate >= 0) || !std::isfinite(rate))
    throw std::invalid_argument("the rate of a controller must be 0 or positive");
  const SingleUse used = use();
  py::object function = py::hasattr(controller, "update") ? controller.attr("update") : controller;
  if (!PyCallable_Check(function.ptr())) {
    throw py::type_error("a controller is a function of (measurements, interval, commands), or has a method update");
  }
  py::object state = py::none();
  if (py::hasattr(controller, "state")) {
    state = controller.attr("state");
    if (!py::isinstance<py::array_t<double, py::array::c_style>>(state) ||
        !state.attr("flags").attr("writeable").cast<bool>()) {
      throw py::type_error("the state of a controller must be a writeable, contiguous numpy array of float64");
    }
  }
  const Structure& parts = *structure();
  simulation_->add_controller(std::make_unique<PythonController>(std::move(function), std::move(state),
                                                                 rate > 0 ? 1 / rate : 0.0, parts.bodies.size(),
                                                                 static_cast<std::size_t>(parts.rope_count)));
}

PythonCommands& PythonSimulation::held() {
  const SingleUse used = use();
  if (script_ == nullptr) {
    const Structure& parts = *structure();
    auto script = std::make_unique<PythonController>(py::none(), py::none(), 0.0, parts.bodies.size(),
                                                     static_cast<std::size_t>(parts.rope_count));
    script_ = script.get();
    simulation_->add_controller(std::move(script));
  }
  return script_->held();
}

std::int32_t PythonSimulation::body_index(const py::object& body) {
  const std::vector<StructureBody>& bodies = structure()->bodies;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const bool is_meant = py::isinstance<py::str>(body) ? body.cast<std::string>() == bodies[i].name
                                                        : body.cast<std::int64_t>() == static_cast<std::int64_t>(i);
    if (is_meant) return static_cast<std::int32_t>(i);
  }
  std::string names;
  for (const StructureBody& known : bodies) names += fmt::format("{}\"{}\"", names.empty() ? "" : ", ", known.name);
  throw py::index_error(fmt::format("there is no body {}; there are {}", py::repr(body).cast<std::string>(), names));
}

void advance_all(const std::vector<PythonSimulation*>& simulations, const std::vector<double>& until, int threads) {
  if (simulations.size() != until.size()) throw std::invalid_argument("there must be one time for each simulation");
  std::vector<std::unique_ptr<SingleUse>> uses;
  for (PythonSimulation* simulation : simulations) {
    uses.push_back(std::make_unique<SingleUse>(simulation->busy_, "simulation"));
  }
  std::vector<std::exception_ptr> errors(simulations.size());
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    for (std::size_t i = next++; i < simulations.size(); i = next++) {
      try {
        demand(simulations[i]->simulation_->advance(until[i]));
      } catch (...) {
        errors[i] = std::current_exception();
      }
    }
  };
  {
    const py::gil_scoped_release unlocked;
    const int helpers = std::min<int>(threads, static_cast<int>(simulations.size())) - 1;
    std::vector<std::jthread> team;
    for (int i = 0; i < helpers; ++i) team.emplace_back(work);
    work();
  }
  for (const std::exception_ptr& error : errors) {
    if (error) std::rethrow_exception(error);
  }
  look_at_signals();
}

}  // namespace netpocket::python
