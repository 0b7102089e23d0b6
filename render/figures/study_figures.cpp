#include "render/figures/study_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "engine/statistics/empirical_distribution.h"
#include "engine/statistics/proportion.h"
#include "render/figures/capture_map.h"
#include "render/figures/drawn_captures.h"
#include "render/figures/rich_text.h"
#include "render/figures/search_figures.h"
#include "render/figures/sensitivity_figure.h"
#include "render/figures/study_curves.h"

namespace netpocket {
namespace {

constexpr double kConfidence = 0.95;

using Column = ResultColumn;

// The inputs that decide most, at most `count`.
std::vector<const Column*> deciding_inputs(const StudyResults& results, std::size_t count) {
  std::vector<const Column*> inputs;
  for (const InputInfluence& influence : input_influences(results)) {
    if (inputs.size() < count) inputs.push_back(&results.inputs[influence.input]);
  }
  return inputs;
}

Figure capture_map(const StudyResults& results) {
  const auto inputs = deciding_inputs(results, 2);
  if (inputs.size() < 2) return {.title = "Captures", .panels = {{}}};
  Figure figure = make_capture_map(results, *inputs[0], *inputs[1]);
  const ProbabilityContours contours = probability_contours(results, *inputs[0], *inputs[1]);
  Panel& panel = figure.panels[0];
  panel.curves.insert(panel.curves.end(), contours.curves.begin(), contours.curves.end());
  panel.title = contours.quality;
  return figure;
}

constexpr std::int64_t kMostOfCurve = 2000;  // points: more than a printed figure can show

bool is_unknown(double value) { return std::isnan(value); }

// Whether the estimate from the first `judged` of `count` captures is a point of the curve: each of the first ones, the
// last one, and every so many between.
bool is_shown(std::int64_t judged, std::int64_t count) {
  constexpr std::int64_t kAllOfTheFirst = kMostOfCurve / 2;
  const std::int64_t stride = std::max<std::int64_t>(1, 2 * count / kMostOfCurve);
  return count <= kMostOfCurve || judged <= kAllOfTheFirst || judged % stride == 0 || judged == count;
}

Figure convergence(const StudyResults& results) {
  Figure figure{.title = "Probability of capture", .panels = {{}}, .width_mm = 140, .height_mm = 80};
  Curve estimate = plain_line(kBlack, 0.9, "estimate"), lower = plain_line(kBlue, 0.9, "95 % interval (Wilson)"),
        upper = plain_line(kBlue);
  const auto count = static_cast<std::int64_t>(results.size()) - std::ranges::count_if(results.captured, is_unknown);
  std::int64_t captured = 0, judged = 0;
  for (const double value : results.captured) {
    if (std::isnan(value)) continue;
    captured += value == 1 ? 1 : 0;
    ++judged;
    if (!is_shown(judged, count)) continue;
    const Interval interval = wilson_interval(captured, judged, kConfidence);
    for (Curve* curve : {&estimate, &lower, &upper}) curve->x.push_back(static_cast<double>(judged));
    estimate.y.push_back(static_cast<double>(captured) / static_cast<double>(judged));
    lower.y.push_back(interval.lower);
    upper.y.push_back(interval.upper);
  }
  figure.panels[0].x.title = "Captures";
  figure.panels[0].y.title = "Probability of capture";
  figure.panels[0].curves = {lower, upper, estimate};
  return figure;
}

Curve steps_of(const Column& column) {
  std::vector<double> values;
  for (const double value : column.values) {
    if (std::isfinite(value)) values.push_back(value);
  }
  std::ranges::sort(values);
  Curve curve = plain_line(kBlue);
  const auto add = [&](std::size_t value, std::size_t count) {
    curve.x.push_back(values[value]);
    curve.y.push_back(static_cast<double>(count) / static_cast<double>(values.size()));
  };
  const std::size_t steps = std::min(values.size(), static_cast<std::size_t>(kMostOfCurve));
  for (std::size_t i = 0; i < steps; ++i) {
    // Of many values the step goes up by that of several.
    const std::size_t value = i * values.size() / steps, next = (i + 1) * values.size() / steps;
    add(value, value);
    add(next - 1, next);
  }
  return curve;
}

Figure distributions(const StudyResults& results) {
  const std::vector<std::string> names = {"first_contact_time", "closed_time",      "smallest_gap",
                                          "escape_depth",       "utilisation_peak", "peak_fy_N",
                                          "modified_index",     "covered_share",    "angular_momentum_end"};
  Figure figure{.title = "Distributions of what was measured", .panels = {}, .columns = 3, .height_mm = 150};
  for (const std::string& name : names) {
    const Column* column = results.find(name);
    if (!column) continue;
    figure.panels.push_back(panel_of(axis_title(*column), "Share below", {steps_of(*column)}));
  }
  if (figure.panels.empty()) figure.panels.emplace_back();
  return figure;
}

struct Share {
  std::int64_t captured = 0, judged = 0;
  double value() const { return static_cast<double>(captured) / static_cast<double>(judged); }
};

struct Difference {
  double value = 0, lower = 0, upper = 0;
};

// Newcombe (1998), method 10.
Difference difference(const Share& high, const Share& low) {
  if (high.judged == 0 || low.judged == 0) return {};
  const Interval one = wilson_interval(high.captured, high.judged, kConfidence),
                 two = wilson_interval(low.captured, low.judged, kConfidence);
  const double p = high.value(), q = low.value();
  return {p - q, p - q - std::hypot(p - one.lower, two.upper - q), p - q + std::hypot(one.upper - p, q - two.lower)};
}

// Shares of captures with a value above the median of all, and of the others.
Difference split_at_median(const std::vector<double>& values, const std::vector<double>& captured) {
  std::vector<double> known;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!std::isnan(captured[i]) && std::isfinite(values[i])) known.push_back(values[i]);
  }
  if (known.empty()) return {};
  const double median = EmpiricalDistribution(known).quantile(0.5);
  Share high, low;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (std::isnan(captured[i]) || !std::isfinite(values[i])) continue;
    Share& share = values[i] > median ? high : low;
    ++share.judged;
    share.captured += captured[i] == 1 ? 1 : 0;
  }
  return difference(high, low);
}

std::vector<double> distances_from_median(const std::vector<double>& values) {
  std::vector<double> known;
  std::ranges::copy_if(values, std::back_inserter(known), [](double v) { return std::isfinite(v); });
  std::vector<double> distances = values;
  if (known.empty()) return distances;
  const double median = EmpiricalDistribution(known).quantile(0.5);
  for (double& value : distances) value = std::abs(value - median);
  return distances;
}

// Bars of a tornado: a thick line for the difference, a thin one for its interval.
void add_bar(Panel& panel, double height, const Difference& d, FigureColour colour, const std::string& label) {
  Curve bar = plain_line(colour, 5, label), interval = plain_line(kBlack, 0.8);
  bar.x = {0, d.value};
  interval.x = {d.lower, d.upper};
  bar.y = interval.y = {height, height};
  panel.curves.insert(panel.curves.end(), {bar, interval});
}

Figure influence(const StudyResults& results) {
  const auto all = input_influences(results);
  Figure figure{.title = "What decides the capture", .panels = {{}}, .width_mm = 160};
  figure.height_mm = 40 + 9 * static_cast<double>(all.size());
  Panel& panel = figure.panels[0];
  panel.x.title = "Change of the probability of capture, with 95 % intervals";
  std::string names;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const InputInfluence& in = all[i];
    const double height = -static_cast<double>(i + 1);
    add_bar(panel, height + 0.15, {in.difference, in.lower, in.upper}, kBlue, i == 0 ? "large against small" : "");
    add_bar(panel, height - 0.15, {in.spread, in.spread_lower, in.spread_upper}, kOrange,
            i == 0 ? "far from the median against near" : "");
    panel.y.names.push_back({height, plain_text(results.inputs[in.input].name)});
  }
  panel.y.limits = AxisLimits{-static_cast<double>(all.size()) - 0.7, -0.3};
  double farthest = 0.1;
  for (const InputInfluence& in : all) {
    for (const double end : {in.lower, in.upper, in.spread_lower, in.spread_upper}) {
      farthest = std::max(farthest, std::abs(end));
    }
  }
  panel.x.limits = AxisLimits{-1.05 * farthest, 1.05 * farthest};
  return figure;
}

Figure parallel_coordinates(const StudyResults& results) {
  constexpr std::size_t kMostLines = 400;
  Figure figure{.title = "Captures over the inputs", .panels = {{}}, .width_mm = 240, .height_mm = 110};
  Panel& panel = figure.panels[0];
  panel.x.title = drawn_text(results.size(), kMostLines);
  panel.y.title = "From smallest to largest";
  Curve captured = plain_line(kSkyBlue, 0.4, "captured");
  Curve missed = plain_line(kVermillion, 0.4, "missed");
  std::vector<ColumnRange> ranges;
  for (const Column& input : results.inputs) ranges.push_back(range_of(input));
  for (std::size_t i = 0; i < results.size(); ++i) {
    if (std::isnan(results.captured[i]) || !is_drawn(i, results.size(), kMostLines)) continue;
    Curve& curve = results.captured[i] == 1 ? captured : missed;
    for (std::size_t c = 0; c < ranges.size(); ++c) {
      curve.x.push_back(static_cast<double>(c + 1));
      curve.y.push_back(ranges[c].fraction(results.inputs[c].values[i]));
    }
    curve.x.push_back(kGapInCurve);
    curve.y.push_back(kGapInCurve);
  }
  for (std::size_t c = 0; c < ranges.size(); ++c) {
    const std::string& name = results.inputs[c].name;
    // Without its group, which would not find room.
    panel.x.names.push_back({static_cast<double>(c + 1), plain_text(name.substr(name.find('.') + 1))});
  }
  panel.curves = {captured, missed};
  // Names of the outer inputs need room.
  panel.x.limits = AxisLimits{0.5, static_cast<double>(std::max<std::size_t>(ranges.size(), 1)) + 0.5};
  return figure;
}

Figure scatter_matrix(const StudyResults& results) {
  const auto inputs = deciding_inputs(results, 4);
  const auto count = static_cast<int>(inputs.size());
  Figure figure{.title = title_with_drawn("Captures over pairs of inputs", results.size()),
                .panels = {},
                .columns = std::max(1, count),
                .width_mm = 240,
                .height_mm = 220};
  for (const Column* y : inputs) {
    for (const Column* x : inputs) {
      Panel panel = panel_of(axis_title(*x), axis_title(*y), {});
      if (x == y) {
        panel.y.title = "Share below";
        panel.curves = {steps_of(*x)};
      } else {
        panel.curves = captures_over(results, *x, *y, false);
      }
      figure.panels.push_back(std::move(panel));
    }
  }
  if (figure.panels.empty()) figure.panels.emplace_back();
  return figure;
}

using MakeStudyFigure = Figure (*)(const StudyResults&);

const std::vector<std::pair<std::string, MakeStudyFigure>> kStudyFigures = {
    {"capture_map", capture_map},
    {"convergence", convergence},
    {"distributions", distributions},
    {"influence", influence},
    {"parallel_coordinates", parallel_coordinates},
    {"scatter_matrix", scatter_matrix},
    {"sensitivity", sensitivity_figure},
    {"optimisation", optimisation_figure},
    {"rare_failure", rare_failure_figure}};

}  // namespace

const std::vector<std::string>& study_figure_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> list;
    for (const auto& [name, make] : kStudyFigures) list.push_back(name);
    return list;
  }();
  return names;
}

std::vector<std::string> suitable_study_figures(const StudyResults& results) {
  std::vector<std::string> names = study_figure_names();
  std::erase_if(names, [&results](const std::string& name) {
    return (name == "sensitivity" && results.sensitivity.empty()) ||
           (name == "optimisation" && results.optimisation.empty()) || (name == "rare_failure" && results.rare.empty());
  });
  return names;
}

Figure make_study_figure(std::string_view name, const StudyResults& results) {
  for (const auto& [known, make] : kStudyFigures) {
    if (known == name) return make(results);
  }
  throw FigureError(
      fmt::format("\"{}\" is no figure of a study; these are: {}", name, fmt::join(study_figure_names(), ", ")));
}

std::vector<InputInfluence> input_influences(const StudyResults& results) {
  std::vector<InputInfluence> list;
  for (std::size_t i = 0; i < results.inputs.size(); ++i) {
    const std::vector<double>& values = results.inputs[i].values;
    const Difference shift = split_at_median(values, results.captured);
    const Difference spread = split_at_median(distances_from_median(values), results.captured);
    list.push_back({i, shift.value, shift.lower, shift.upper, spread.value, spread.lower, spread.upper});
  }
  const bool is_judged = std::ranges::any_of(results.captured, [](double c) { return !std::isnan(c); });
  if (!is_judged) return {};
  std::ranges::stable_sort(list, [](const auto& a, const auto& b) { return a.size() > b.size(); });
  return list;
}

}  // namespace netpocket
