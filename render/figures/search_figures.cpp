#include "render/figures/search_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "render/figures/rich_text.h"
#include "render/figures/study_curves.h"

namespace netpocket {
namespace {

const std::vector<double>& column_of(const std::vector<ResultColumn>& table, const std::string& name) {
  static const std::vector<double> none;
  const auto found = std::ranges::find(table, name, &ResultColumn::name);
  return found == table.end() ? none : found->values;
}

// The best objective so far, known at the end of each generation.
Curve best_by_generation(const std::vector<double>& generation, const std::vector<double>& best) {
  Curve curve = plain_line(kBlack, 1.4, "best so far");
  for (std::size_t i = 0; i < generation.size(); ++i) {
    const bool is_last = i + 1 == generation.size() || generation[i + 1] != generation[i];
    if (!is_last || !std::isfinite(best[i])) continue;
    if (!curve.x.empty()) {  // a step
      curve.x.push_back(generation[i]);
      curve.y.push_back(curve.y.back());
    }
    curve.x.push_back(generation[i]);
    curve.y.push_back(best[i]);
  }
  return curve;
}

// Whole powers of ten in the range of an axis of logarithms.
std::vector<NamedTick> powers_of_ten(double lowest, double highest) {
  std::vector<NamedTick> ticks;
  for (double power = std::floor(lowest); power <= std::ceil(highest); ++power) {
    ticks.push_back({power, power == 0 ? "1" : fmt::format("10^{{\u2212{:g}}}", -power)});
  }
  return ticks;
}

}  // namespace

Figure optimisation_figure(const StudyResults& results) {
  Figure figure{.title = "Search for the best parameters", .panels = {{}}, .width_mm = 160, .height_mm = 90};
  const auto &generation = column_of(results.optimisation, "generation"),
             &objective = column_of(results.optimisation, "objective"),
             &violation = column_of(results.optimisation, "violation"),
             &feasible = column_of(results.optimisation, "is_feasible"),
             &best = column_of(results.optimisation, "best_so_far");
  if (generation.empty() || objective.size() != generation.size()) return figure;
  Curve meets = scatter(kSkyBlue, "meets the constraints"), misses = scatter(kVermillion, "does not meet them"),
        amount = scatter(kVermillion, "");
  bool is_constrained = false;
  for (std::size_t i = 0; i < generation.size(); ++i) {
    add_point(feasible[i] == 1 ? meets : misses, generation[i], objective[i]);
    if (feasible[i] == 0) add_point(amount, generation[i], violation[i]);
    is_constrained = is_constrained || feasible[i] == 0;
  }
  if (!is_constrained) meets.label = "candidate";
  const std::string name = results.objective.empty() ? "Objective" : plain_text(results.objective);
  figure.panels = {panel_of("Generation", name, {meets, misses, best_by_generation(generation, best)})};
  const AxisLimits shown{generation.front() - 0.5, generation.back() + 0.5};
  figure.panels[0].x.limits = shown;
  figure.panels[0].x.whole_numbers = true;
  if (!is_constrained) return figure;
  figure.panels.push_back(panel_of("Generation", "Violation of the constraints", {amount}));
  figure.panels[1].x = figure.panels[0].x;
  figure.height_mm = 150;
  return figure;
}

Figure rare_failure_figure(const StudyResults& results) {
  Figure figure{.title = "Probability of a rare failure", .panels = {{}}, .width_mm = 140, .height_mm = 90};
  if (results.rare.size() < 5) return figure;
  const ResultColumn& value = results.rare[1];
  const auto &probability = column_of(results.rare, "probability"), &lower = column_of(results.rare, "lower"),
             &upper = column_of(results.rare, "upper");
  Curve line = plain_line(kBlue, 0.9), marks = scatter(kBlue, "level"),
        intervals = plain_line(kBlack, 0.9, "95 % interval, levels fully correlated");
  double least = 0, most = -INFINITY;
  for (std::size_t i = 0; i < value.values.size(); ++i) {
    const double x = value.values[i], low = std::max(lower[i], 1e-3 * probability[i]);
    line.x.push_back(x);
    line.y.push_back(std::log10(probability[i]));
    add_point(marks, x, line.y.back());
    intervals.x.insert(intervals.x.end(), {x, x, kGapInCurve});
    intervals.y.insert(intervals.y.end(), {std::log10(low), std::log10(std::min(1.0, upper[i])), kGapInCurve});
    least = std::min(least, std::log10(low));
    most = std::max(most, std::log10(std::min(1.0, upper[i])));
  }
  Panel panel = panel_of(axis_title(value), "Probability of this or worse", {intervals, line, marks});
  panel.title = plain_text(results.failure);
  panel.y.names = powers_of_ten(least, most);
  panel.y.limits = AxisLimits{std::floor(least), std::ceil(most)};
  const ColumnRange range = range_of(value);
  const double room = range.to > range.from ? 0.08 * (range.to - range.from) : 1;
  panel.x.limits = AxisLimits{range.from - room, range.to + room};
  figure.panels = {panel};
  return figure;
}

}  // namespace netpocket
