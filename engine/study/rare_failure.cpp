#include "engine/study/rare_failure.h"

#include <fmt/format.h>

#include <cmath>

#include "engine/sampling/normal.h"
#include "engine/study/report_text.h"
#include "engine/study/study_plan.h"
#include "engine/study/study_table.h"

namespace netpocket {
namespace {

// The limit state: the system fails where it is at most 0.
double limit_state(const StudyRareFailure& rare, const StudyRecord& record, RareFailure& failure) {
  if (record["runs"].empty()) {
    ++failure.refused;
    return INFINITY;
  }
  const double value = run_number(record["runs"].front(), rare.of);
  if (std::isnan(value)) {
    ++failure.not_measured;
    return INFINITY;
  }
  return rare.is_above ? rare.limit - value : value - rare.limit;
}

std::string probability_text(const Study& study, const RareFailure& failure) {
  const SubsetResult& result = failure.result;
  const double confidence = 100 * study.estimate.confidence;
  if (!result.is_resolved) {
    return fmt::format(
        "at most about {:.2e}: the last level did not come to the failure ({:g} % confidence: at most {:.2e})",
        result.probability, confidence, failure.interval.upper);
  }
  return fmt::format("{:.2e} ({:.1e} to {:.1e} with {:g} % confidence)", result.probability, failure.interval.lower,
                     failure.interval.upper, confidence);
}

std::string effort_text(const RareFailure& failure) {
  std::string text = fmt::format("{} levels, {} captures", failure.result.levels, failure.result.evaluations);
  if (failure.refused > 0) text += fmt::format(", {} of them refused as not valid", failure.refused);
  if (failure.not_measured > 0) text += fmt::format(", {} without a value", failure.not_measured);
  if (failure.refused + failure.not_measured > 0) text += " (which count as no failure)";
  return text;
}

}  // namespace

std::size_t planned_rare_points(const Study& study) {
  const auto samples = static_cast<std::size_t>(study.rare.samples);
  return samples + static_cast<std::size_t>(study.rare.levels - 1) * (samples - samples / 10);
}

RareFailure find_rare_failure(const Study& study, const RunPoints& run) {
  RareFailure failure;
  std::size_t level = 0, in_level = 0;
  const auto values_at = [&](const Eigen::MatrixXd& normal) {
    std::vector<StudyPoint> points;
    const auto samples = static_cast<std::size_t>(study.rare.samples);
    for (const auto& column : normal.colwise()) {
      std::vector<double> fractions;
      for (const double z : column) fractions.push_back(normal_cumulative(z));
      points.push_back(point_at(study, fractions));
      points.back().place = fmt::format("level {}", level + 1);
      const std::size_t size = level == 0 ? samples : samples - samples / 10;
      if (++in_level == size) {
        ++level;
        in_level = 0;
      }
    }
    const std::vector<StudyRecord> records = run(points);
    Eigen::VectorXd values(normal.cols());
    for (Eigen::Index i = 0; i < values.size(); ++i) {
      values[i] = limit_state(study.rare, records[static_cast<std::size_t>(i)], failure);
    }
    return values;
  };
  const SubsetOptions options = {study.rare.samples, study.rare.levels, static_cast<std::uint64_t>(study.seed)};
  failure.result = subset_simulation(values_at, coordinate_count(study.uncertain), options);
  failure.interval = subset_interval(failure.result, study.estimate.confidence);
  return failure;
}

double level_value(const Study& study, const SubsetLevel& level) {
  return study.rare.is_above ? study.rare.limit - level.limit : study.rare.limit + level.limit;
}

Interval level_interval(const Study& study, const SubsetLevel& level) {
  return subset_interval(
      {.probability = level.probability, .most_variation = level.most_variation, .is_resolved = true},
      study.estimate.confidence);
}

std::string failure_name(const StudyRareFailure& rare) {
  return fmt::format("{} {} {:g}", rare.of, rare.is_above ? ">=" : "<=", rare.limit);
}

std::string rare_failure_csv(const Study& study, const RareFailure& failure) {
  std::string text = fmt::format("level,{},probability,lower,upper\n", study.rare.of);
  for (std::size_t i = 0; i < failure.result.steps.size(); ++i) {
    const SubsetLevel& step = failure.result.steps[i];
    const Interval interval = level_interval(study, step);
    text += fmt::format("{},{},{},{},{}\n", i + 1, level_value(study, step), step.probability, interval.lower,
                        interval.upper);
  }
  return text;
}

std::string rare_failure_text(const Study& study, const RareFailure& failure) {
  return fmt::format("probability of {}: {}; {}\n", failure_name(study.rare), probability_text(study, failure),
                     effort_text(failure));
}

std::string rare_failure_report(const Study& study, const RareFailure& failure) {
  std::string text = fmt::format("# {}\n\n{}.\n\n", study.name, study.description);
  text += fmt::format("Probability of `{}`: {}.\n\nSubset simulation: {}, {} a level.\n\n", failure_name(study.rare),
                      probability_text(study, failure), effort_text(failure), study.rare.samples);
  text += markdown_header({"level", study.rare.of, "probability"});
  for (std::size_t i = 0; i < failure.result.steps.size(); ++i) {
    const SubsetLevel& step = failure.result.steps[i];
    text += fmt::format("| {} | {:.4g} | {:.2e} |\n", i + 1, level_value(study, step), step.probability);
  }
  return text + fmt::format(
                    "\nCoefficient of variation: {:.2f} if the levels were independent, {:.2f} if they were fully "
                    "correlated; the interval takes the latter.\n\n",
                    failure.result.variation, failure.result.most_variation);
}

}  // namespace netpocket
