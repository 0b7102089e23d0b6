#include "engine/study/measured_run.h"

#include <cmath>
#include <limits>

#include "engine/analysis/report.h"
#include "engine/analysis/run_in_memory.h"
#include "engine/capture/observe_run.h"
#include "engine/capture/recorded_scenario.h"
#include "engine/scenario/parameters.h"
#include "engine/state/phase.h"

namespace netpocket {
namespace {

// The values that a simulation has: numbers where the key names one, three numbers for a vector, else TOML texts.
StudyRecord used_values(const Scenario& scenario, const std::vector<std::string>& keys) {
  StudyRecord used = StudyRecord::object();
  for (const std::string& key : keys) {
    const auto number = number_of(scenario, key);
    used[key] = number ? StudyRecord(*number) : StudyRecord(value_of(scenario, key));
  }
  return used;
}

StudyRecord metrics_json(const std::vector<Metric>& metrics) {
  StudyRecord json = StudyRecord::object();
  for (const Metric& metric : metrics) {
    json[metric.name] = std::isnan(metric.value) ? StudyRecord() : StudyRecord(metric.value);
  }
  return json;
}

StudyRecord run_json(const RunData& run, const std::string& variant, const Scenario& scenario,
                     const std::vector<std::string>& used, const std::vector<Metric>& metrics) {
  StudyRecord json = {{"variant", variant}};
  json.update(summary_json(run));
  json["used"] = used_values(scenario, used);
  json["metrics"] = metrics_json(metrics);
  return json;
}

MetricOptions options_of(const Scenario& scenario, const RunOrigin& origin, const Structure& structure) {
  MetricOptions options = metric_options(scenario, structure);
  options.closing_end = phase_end(origin.phases, kClosing);
  options.phases = origin.phases;
  options.interval = std::numeric_limits<double>::infinity();  // nobody looks at quantities over time
  return options;
}

StudyRecord observed(const Scenario& scenario, const std::string& variant, const std::vector<std::string>& used,
                     const RunOptions& options, const std::function<void(double)>& progress,
                     const std::stop_token& stop) {
  Simulation simulation(scenario, {options.threads});
  const RunOrigin origin = run_origin(scenario, options);
  RunInMemory run(origin, simulation.structure());
  MetricsCollector collector(run.structure(), options_of(simulation.scenario(), origin, run.structure()));
  const auto look = [&](const Snapshot& snapshot) {
    run.add(snapshot);
    collector.add(snapshot);
    progress(snapshot.time);
  };
  const RunResult result = observe_run(simulation, look, stop);
  if (result.status.reason == RunReason::stopped) return {};
  run.finish(result.status, result.statistics);
  return run_json(run, variant, simulation.scenario(), used, collector.metrics());
}

}  // namespace

StudyRecord measured_run(const Scenario& scenario, const std::string& variant, const std::vector<std::string>& used,
                         const std::string& file, const RunOptions& options,
                         const std::function<void(double)>& progress, const std::stop_token& stop) {
  if (file.empty()) return observed(scenario, variant, used, options, progress, stop);
  const RunResult result = run_to_recording(
      scenario, file, options, [&](const RunProgress& p) { progress(p.time); }, stop);
  if (result.status.reason == RunReason::storage_failed) throw RecordingError(result.status.message);
  if (result.status.reason == RunReason::stopped) return {};
  const Recording recording(file);
  const ScenarioResult recorded = recorded_scenario(recording);
  const Scenario& applied = recorded.ok() ? recorded.scenario : scenario;
  const MetricOptions metric_options = options_of(applied, recording.origin(), recording.structure());
  return run_json(recording, variant, applied, used, metrics_of(recording, metric_options).metrics);
}

}  // namespace netpocket
