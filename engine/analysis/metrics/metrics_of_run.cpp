#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "engine/analysis/metrics/metrics.h"
#include "engine/recording/recording.h"
#include "engine/scenario/parameters.h"
#include "engine/scenario/scenario.h"
#include "engine/scenario/target_shape.h"
#include "engine/state/phase.h"
#include "engine/state/pocket_groups.h"

namespace netpocket {
namespace {

using MetricsJson = nlohmann::ordered_json;

// N, at which a cord of a linear material reaches its breaking strain.
double breaking_force(const CordParameters& cord) {
  return cord.youngs_modulus * std::numbers::pi / 4 * cord.diameter * cord.diameter * kBreakingStrain;
}

MetricsJson null_for_nan(double value) { return std::isnan(value) ? MetricsJson() : MetricsJson(value); }

MetricsJson nulls_for_nan(const std::vector<double>& values) {
  MetricsJson list = MetricsJson::array();
  for (const double value : values) list.push_back(null_for_nan(value));
  return list;
}

}  // namespace

MetricOptions metric_options(const Scenario& scenario, const Structure& structure) {
  MetricOptions options;
  if (scenario.system != kPocketSystem) return options;
  options.strengths.resize(pocket_groups().size());
  options.strengths[static_cast<std::size_t>(PocketGroup::net)] = breaking_force(scenario.net);
  options.strengths[static_cast<std::size_t>(PocketGroup::closing_ropes)] = breaking_force(scenario.rope);
  for (const StructureBody& body : structure.bodies) {
    if (body.role == BodyRole::target) options.target_inertia = target_inertia(scenario.target, body.shape);
  }
  return options;
}

MetricsOfRun metrics_of(const Recording& recording, const MetricOptions& options) {
  MetricOptions complete = options;
  if (std::isnan(complete.closing_end)) complete.closing_end = phase_end(recording.origin().phases, kClosing);
  if (complete.phases.empty()) complete.phases = recording.origin().phases;
  MetricsCollector collector(recording.structure(), complete);
  for (std::size_t i = 0; i < recording.frame_count(); ++i) collector.add(recording.frame(i));
  return {collector.metrics(), collector.history(), recording.origin().draft};
}

std::string metrics_text(const std::vector<Metric>& metrics) {
  std::string text;
  for (const Metric& metric : metrics) {
    const std::string value = std::isnan(metric.value) ? "-" : fmt::format("{:.6g}", metric.value);
    text += fmt::format("{:<24}{:>12} {:<6} {}\n", metric.name, value, metric.unit == "1" ? "" : metric.unit,
                        metric.meaning);
  }
  return text;
}

std::string metrics_csv(const std::vector<Metric>& metrics) {
  std::string text = "name,value,unit,meaning\n";
  for (const Metric& metric : metrics) {
    const std::string value = std::isnan(metric.value) ? "" : fmt::format("{}", metric.value);
    text += fmt::format("{},{},{},\"{}\"\n", metric.name, value, metric.unit, metric.meaning);
  }
  return text;
}

std::string metrics_json(const MetricsOfRun& run) {
  MetricsJson list = MetricsJson::object();
  for (const Metric& metric : run.metrics) {
    list[metric.name] = {{"value", null_for_nan(metric.value)}, {"unit", metric.unit}, {"meaning", metric.meaning}};
  }
  const MetricsJson history = {{"time", nulls_for_nan(run.history.time)},
                               {"mouth_area", nulls_for_nan(run.history.mouth_area)},
                               {"hull_volume", nulls_for_nan(run.history.hull_volume)}};
  MetricsJson json = {{"metrics", list}, {"history", history}};
  if (!run.draft.empty()) json["draft"] = run.draft;
  return json.dump(2) + "\n";
}

}  // namespace netpocket
