// What whole captures of a campaign cost, by the fidelity of the pocket, and a step of a thrown net. Processor time.

#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <algorithm>
#include <stdexcept>

#include "engine/capture/simulation.h"
#include "engine/scenario/read_scenario.h"
#include "engine/study/measured_run.h"
#include "engine/study/read_study.h"
#include "engine/study/study_plan.h"

namespace netpocket {
namespace {

constexpr const char* kScenarios = NETPOCKET_SOURCE_DIR "/scenarios/";

double used_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_utime.tv_sec) + 1e-6 * static_cast<double>(usage.ru_utime.tv_usec);
}

// The first captures of a study, as a campaign runs them: with all that is measured of each.
void campaign(benchmark::State& state, const char* study_file, std::size_t variant) {
  constexpr std::size_t kCaptures = 32;
  const StudyResult read = read_study_file(std::string(kScenarios) + "studies/" + study_file);
  if (!read.ok()) throw std::runtime_error(read.diagnostics.text());
  const StudyPlan plan(read.study);
  for (auto _ : state) {
    double simulated = 0, steps = 0;
    const double start = used_seconds();
    for (std::size_t i = 0; i < kCaptures; ++i) {
      const Scenario scenario = study_scenario(read.study, plan.point(i), read.study.variants[variant]).scenario;
      const StudyRecord run = measured_run(scenario, "", {}, "", {}, [](double) {}, {});
      simulated += run["simulated_seconds"].get<double>();
      steps += run["steps"].get<double>();
    }
    const double seconds = used_seconds() - start;
    state.SetIterationTime(seconds / kCaptures);
    state.counters["x_real_time"] = simulated / seconds;
    state.counters["per_minute"] = 60 * kCaptures / seconds;
    state.counters["steps"] = steps / kCaptures;
  }
}
void campaign_fine(benchmark::State& state) { campaign(state, "draft_bias.toml", 0); }
void campaign_coarse(benchmark::State& state) { campaign(state, "capture_probability.toml", 0); }
void campaign_draft(benchmark::State& state) { campaign(state, "draft_bias.toml", 1); }
BENCHMARK(campaign_fine)->Name("campaign/fine")->Iterations(1)->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK(campaign_coarse)->Name("campaign/coarse")->Iterations(1)->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK(campaign_draft)->Name("campaign/draft")->Iterations(1)->UseManualTime()->Unit(benchmark::kMillisecond);

// The net of thrown_net.toml in free flight. The counters are those of the fastest stretch.
void thrown_net_step(benchmark::State& state) {
  constexpr double kBegin = 1, kStretch = 0.25;  // s
  const ScenarioResult read = read_scenario_file(std::string(kScenarios) + "thrown_net.toml");
  if (!read.ok()) throw std::runtime_error(read.diagnostics.text());
  Simulation simulation(read.scenario);
  double until = kBegin, fastest = 1;
  simulation.advance(until);
  const auto elements = static_cast<double>(simulation.structure().elements.size());
  for (auto _ : state) {
    const std::int64_t first = simulation.statistics().steps;
    const double start = used_seconds();
    simulation.advance(until += kStretch);
    const double seconds = used_seconds() - start;
    const double steps = static_cast<double>(simulation.statistics().steps - first);
    state.SetIterationTime(seconds / steps);
    fastest = std::min(fastest, seconds / (steps * elements));
  }
  state.counters["elements"] = elements;
  state.counters["per_element"] = fastest;
}
BENCHMARK(thrown_net_step)->Name("thrown_net/step")->Iterations(12)->UseManualTime()->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace netpocket
