// Generates the points of a study. Halton sequences are shifted by a random vector modulo 1 (Cranley & Patterson, SIAM
// J. Numer. Anal. 13 (1976) 904), so that different seeds give different samples that are equally even.

#include <fmt/format.h>

#include <cmath>
#include <random>

#include "engine/math/power.h"
#include "engine/sampling/halton_sequence.h"
#include "engine/scenario/check_scenario.h"
#include "engine/study/read_study.h"
#include "engine/study/study.h"

namespace netpocket {
namespace {

// Number at a fraction of a range.
double between(const Axis& axis, double fraction) {
  if (axis.logarithmic) return axis.from * power(axis.to / axis.from, fraction);
  return axis.from + fraction * (axis.to - axis.from);
}

std::string number_text(const Axis& axis, double value) {
  if (axis.whole) return fmt::format("{}", std::llround(value));
  // Twelve digits suffice for any parameter and hide the rounding errors of the steps.
  return fmt::format("{:.12g}", value);
}

// A range may hold fewer whole numbers than it has steps. Each is taken once.
std::vector<std::string> grid_values(const Axis& axis) {
  if (!axis.values.empty()) return axis.values;
  std::vector<std::string> values;
  for (int i = 0; i < axis.steps; ++i) {
    std::string text = number_text(axis, between(axis, static_cast<double>(i) / (axis.steps - 1)));
    if (values.empty() || values.back() != text) values.push_back(std::move(text));
  }
  return values;
}

// `fraction` in [0, 1).
std::string sampled_value(const Axis& axis, double fraction) {
  if (!axis.values.empty()) {
    return axis.values[static_cast<std::size_t>(fraction * static_cast<double>(axis.values.size()))];
  }
  if (!axis.whole) return number_text(axis, between(axis, fraction));
  // All whole numbers, including both ends, have the same share.
  return fmt::format("{}", static_cast<std::int64_t>(std::floor(axis.from + fraction * (axis.to - axis.from + 1))));
}

// Values of one combination, by axis. The last axis changes fastest.
std::vector<Setting> grid_settings(const std::vector<Axis>& axes, const std::vector<std::vector<std::string>>& values,
                                   std::size_t combination) {
  std::vector<Setting> settings(axes.size());
  for (std::size_t i = axes.size(); i-- > 0;) {
    settings[i] = {axes[i].key, values[i][combination % values[i].size()]};
    combination /= values[i].size();
  }
  return settings;
}

std::vector<std::vector<Setting>> grid(const Study& study) {
  std::vector<std::vector<std::string>> values;
  std::size_t count = 1;
  for (const Axis& axis : study.axes) {
    values.push_back(grid_values(axis));
    count *= values.back().size();
  }
  std::vector<std::vector<Setting>> points(count);
  for (std::size_t i = 0; i < count; ++i) points[i] = grid_settings(study.axes, values, i);
  return points;
}

std::vector<std::vector<Setting>> halton(const Study& study) {
  std::mt19937_64 random(static_cast<std::uint64_t>(study.seed));
  std::vector<double> shift(study.axes.size());
  // The upper 53 bits of the generator are the same on every platform. Standard distributions are not.
  for (double& s : shift) s = std::ldexp(static_cast<double>(random() >> 11), -53);
  std::vector<std::vector<Setting>> points(static_cast<std::size_t>(study.samples));
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t a = 0; a < study.axes.size(); ++a) {
      const double fraction = shifted(radical_inverse(i, prime(static_cast<int>(a))), shift[a]);
      points[i].push_back({study.axes[a].key, sampled_value(study.axes[a], fraction)});
    }
  }
  return points;
}

}  // namespace

std::vector<StudyPoint> study_points(const Study& study) {
  const auto combinations = study.sampling == Sampling::grid ? grid(study) : halton(study);
  std::vector<StudyPoint> points;
  for (const NamedSettings& place : study.places) {
    for (const auto& combination : combinations) {
      StudyPoint point{place.name, study.settings};
      point.settings.insert(point.settings.end(), place.settings.begin(), place.settings.end());
      point.settings.insert(point.settings.end(), combination.begin(), combination.end());
      points.push_back(std::move(point));
    }
  }
  for (int draw = 1; draw <= study.ensemble.runs; ++draw) {
    StudyPoint point = points.front();
    point.draw = draw;
    point.settings.push_back({"solver.perturbation", fmt::format("{}", study.ensemble.perturbation)});
    point.settings.push_back({"solver.seed", fmt::format("{}", draw)});
    points.push_back(std::move(point));
  }
  return points;
}

StudyScenario study_scenario(const Study& study, const StudyPoint& point, const NamedSettings& variant) {
  StudyScenario result{study.base, {}};
  result.diagnostics = apply_settings(result.scenario, point.settings);
  if (result.diagnostics.ok()) result.diagnostics = apply_settings(result.scenario, variant.settings);
  if (!variant.name.empty()) result.scenario.name = variant.name;
  if (result.diagnostics.ok()) result.diagnostics = check_scenario(result.scenario);
  return result;
}

}  // namespace netpocket
