#include "engine/python/memory_run.h"

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>

#include "engine/capture/observe_run.h"
#include "engine/python/conversions.h"
#include "engine/scenario/check_scenario.h"

namespace netpocket::python {
namespace {

MemoryRun run(const Scenario& scenario, const std::stop_token& stop) {
  Simulation simulation(scenario);
  MemoryRun result;
  result.channels = simulation.structure().channels;
  result.values.resize(result.channels->size());
  const auto keep = [&](const Snapshot& frame) {
    for (std::size_t i = 0; i < result.values.size(); ++i) result.values[i].push_back(frame.channels[i]);
  };
  const RunResult outcome = observe_run(simulation, keep, stop);
  result.status = outcome.status;
  result.statistics = outcome.statistics;
  return result;
}

void check(const std::vector<Scenario>& scenarios) {
  for (const Scenario& scenario : scenarios) {
    const Diagnostics problems = check_scenario(scenario);
    if (!problems.ok()) throw ScenarioFault{problems};
  }
}

}  // namespace

std::vector<MemoryRun> run_in_memory(const std::vector<Scenario>& scenarios, int jobs) {
  if (jobs < 1) throw std::invalid_argument("jobs must be at least 1");
  check(scenarios);
  std::vector<MemoryRun> results(scenarios.size());
  std::vector<std::exception_ptr> errors(scenarios.size());
  std::atomic<std::size_t> next = 0, ended = 0;
  bool interrupted = false;
  {
    const py::gil_scoped_release unlocked;
    std::vector<std::jthread> team;
    for (int job = 0; job < std::min<int>(jobs, static_cast<int>(scenarios.size())); ++job) {
      team.emplace_back([&](const std::stop_token& stop) {
        for (std::size_t i = next++; i < scenarios.size(); i = next++) {
          try {
            if (!stop.stop_requested()) results[i] = run(scenarios[i], stop);
          } catch (...) {
            errors[i] = std::current_exception();
          }
          ++ended;
        }
      });
    }
    while (ended < scenarios.size() && !interrupted) {
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
      const py::gil_scoped_acquire lock;
      interrupted = PyErr_CheckSignals() != 0;
    }
    for (std::jthread& member : team) {
      if (interrupted) member.request_stop();
    }
  }
  if (interrupted) throw py::error_already_set();
  for (const std::exception_ptr& error : errors) {
    if (error) std::rethrow_exception(error);
  }
  return results;
}

}  // namespace netpocket::python
