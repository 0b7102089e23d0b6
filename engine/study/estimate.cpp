#include "engine/study/estimate.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "engine/statistics/empirical_distribution.h"
#include "engine/statistics/proportion.h"
#include "engine/study/study_table.h"

namespace netpocket {
namespace {

constexpr std::size_t kMostGroupsShown = 20;

std::string short_text(double value) { return fmt::format("{:.4g}", value); }

// Empty where there is no number.
std::string cell(double value) { return std::isfinite(value) ? fmt::format("{}", value) : ""; }

std::string quoted_cell(const std::string& text) {
  std::string cell = "\"";
  for (const char c : text) cell.append(c == '"' ? 2 : 1, c);
  return cell + "\"";
}

std::string group_name(const Study& study, const StudyPlan& plan, const GroupEstimate& estimate) {
  std::string name;
  const auto add = [&](const std::string& part) { name += (name.empty() ? "" : ", ") + part; };
  const StudyPoint point = plan.point(estimate.group);
  if (!point.place.empty()) add(point.place);
  for (const Axis& axis : study.axes) {
    for (const Setting& setting : point.settings) {
      if (setting.key == axis.key) add(setting.key + " = " + setting.value);
    }
  }
  if (!estimate.variant.empty()) add(estimate.variant);
  return name;
}

std::string tally_text(const GroupEstimate& e) {
  std::string text = fmt::format("{} of {} captures", e.tally.captured, e.tally.judged);
  if (e.tally.not_judged > 0)
    text += fmt::format(", {} more not judged (diverged, at their limit of steps or too short)", e.tally.not_judged);
  if (e.refused > 0) text += fmt::format(", {} points refused", e.refused);
  return text;
}

std::string lines_of(const Study& study, const GroupEstimate& e, const std::string& name) {
  std::string text = name.empty() ? "" : name + "\n";
  if (e.tally.judged == 0) return text + "probability of capture: not known, " + tally_text(e) + "\n";
  text += fmt::format("probability of capture {:.4f} ({:.4f} to {:.4f} with {:g} % confidence; {})\n", e.probability(),
                      e.wilson.lower, e.wilson.upper, 100 * study.estimate.confidence, tally_text(e));
  for (const QuantileOfColumn& q : e.quantiles) {
    text += fmt::format("  {} {:g} % below {} ({}, {} values)\n", q.column, 100 * q.fraction, short_text(q.value),
                        interval_text(q.interval), q.count);
  }
  return text;
}

}  // namespace

std::string interval_text(const Interval& interval) {
  const bool has_lower = std::isfinite(interval.lower), has_upper = std::isfinite(interval.upper);
  if (has_lower && has_upper) return fmt::format("{} to {}", short_text(interval.lower), short_text(interval.upper));
  if (has_lower) return fmt::format("at least {}", short_text(interval.lower));
  return has_upper ? fmt::format("at most {}", short_text(interval.upper)) : "too few values to bound it";
}

void CaptureTally::add(const StudyRecord& run) {
  if (!run["captured"].is_boolean()) {
    ++not_judged;
    return;
  }
  ++judged;
  captured += run["captured"].get<bool>() ? 1 : 0;
}

double GroupEstimate::probability() const {
  if (tally.judged == 0) return std::numeric_limits<double>::quiet_NaN();
  return static_cast<double>(tally.captured) / static_cast<double>(tally.judged);
}

void CampaignEstimator::add(const StudyRecord& record) {
  const std::size_t group = (record["point"].get<std::size_t>() - 1) % plan_.group_count();
  for (std::size_t v = 0; v < study_.variants.size(); ++v) {
    Sample& sample = samples_[{group, v}];
    sample.values.resize(study_.estimate.of.size());
    if (record["runs"].empty()) {
      ++sample.refused;
      continue;
    }
    const StudyRecord& run = record["runs"][v];
    sample.tally.add(run);
    for (std::size_t c = 0; c < sample.values.size(); ++c) {
      const double value = run_number(run, study_.estimate.of[c]);
      if (!std::isnan(value)) sample.values[c].push_back(value);
    }
  }
}

GroupEstimate CampaignEstimator::estimate(std::size_t group, const std::string& variant, const Sample& sample) const {
  const double confidence = study_.estimate.confidence;
  GroupEstimate result{group, variant, sample.refused, sample.tally, {0, 1}, {0, 1}, {}};
  if (sample.tally.judged > 0) {
    result.wilson = wilson_interval(sample.tally.captured, sample.tally.judged, confidence);
    result.clopper_pearson = clopper_pearson_interval(sample.tally.captured, sample.tally.judged, confidence);
  }
  for (std::size_t c = 0; c < sample.values.size(); ++c) {
    if (sample.values[c].empty()) continue;
    const EmpiricalDistribution distribution(sample.values[c]);
    for (const double fraction : study_.estimate.quantiles) {
      const QuantileEstimate q = distribution.quantile_estimate(fraction, confidence);
      result.quantiles.push_back(
          {study_.estimate.of[c], fraction, static_cast<std::int64_t>(sample.values[c].size()), q.value, q.interval});
    }
  }
  return result;
}

std::vector<GroupEstimate> CampaignEstimator::estimates() const {
  std::vector<GroupEstimate> list;
  for (const auto& [key, sample] : samples_) {
    list.push_back(estimate(key.first, study_.variants[key.second].name, sample));
  }
  return list;
}

std::string estimates_text(const Study& study, const std::vector<GroupEstimate>& estimates) {
  const StudyPlan plan(study);
  std::string text;
  for (std::size_t i = 0; i < estimates.size() && i < kMostGroupsShown; ++i) {
    text += lines_of(study, estimates[i], group_name(study, plan, estimates[i]));
  }
  if (estimates.size() > kMostGroupsShown) text += fmt::format("and {} more\n", estimates.size() - kMostGroupsShown);
  return text;
}

std::string estimates_csv(const Study& study, const std::vector<GroupEstimate>& estimates) {
  const StudyPlan plan(study);
  std::string text = "point,group,of,statistic,value,lower,upper,count,not_judged,refused\n";
  for (const GroupEstimate& e : estimates) {
    const std::string first = fmt::format("{},{}", e.group + 1, quoted_cell(group_name(study, plan, e)));
    const auto add = [&](const std::string& of, const std::string& statistic, double value, const Interval& interval,
                         std::int64_t count) {
      text += fmt::format("{},{},{},{},{},{},{},{},{}\n", first, of, statistic, cell(value), cell(interval.lower),
                          cell(interval.upper), count, e.tally.not_judged, e.refused);
    };
    add("captured", "probability_wilson", e.probability(), e.wilson, e.tally.judged);
    add("captured", "probability_clopper_pearson", e.probability(), e.clopper_pearson, e.tally.judged);
    for (const QuantileOfColumn& q : e.quantiles) {
      add(q.column, fmt::format("quantile_{:g}", q.fraction), q.value, q.interval, q.count);
    }
  }
  return text;
}

}  // namespace netpocket
