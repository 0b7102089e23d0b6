#include "engine/study/study_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "engine/math/power.h"
#include "engine/sampling/halton_sequence.h"
#include "engine/statistics/screening.h"
#include "engine/statistics/sobol_indices.h"

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

// Of a sample of the axes: a shift modulo 1 as in halton_sequence.h, from the generator of earlier versions, so that
// their studies keep their points.
std::vector<double> halton_shift(const Study& study) {
  std::mt19937_64 random(static_cast<std::uint64_t>(study.seed));
  std::vector<double> shift(study.axes.size());
  // The upper 53 bits of the generator are the same on every platform. Standard distributions are not.
  for (double& s : shift) s = std::ldexp(static_cast<double>(random() >> 11), -53);
  return shift;
}

DesignKind design_kind(Sampling sampling) {
  if (sampling == Sampling::latin_hypercube) return DesignKind::latin_hypercube;
  if (sampling == Sampling::sobol) return DesignKind::sobol;
  return sampling == Sampling::halton ? DesignKind::halton : DesignKind::monte_carlo;
}

void append(std::vector<Setting>& settings, const std::vector<Setting>& more) {
  settings.insert(settings.end(), more.begin(), more.end());
}

// Values of the uncertain inputs. `others`: all other settings, which relative values refer to.
std::vector<Setting> drawn(const Study& study, std::span<const double> fractions, const std::vector<Setting>& others) {
  Scenario nominal = study.base;
  apply_settings(nominal, others);
  std::vector<Setting> settings;
  for (const UncertainInput& input : study.uncertain) {
    append(settings, drawn_settings(input, fractions, nominal));
    fractions = fractions.subspan(static_cast<std::size_t>(coordinate_count(input)));
  }
  return settings;
}

}  // namespace

std::string axis_value(const Axis& axis, double fraction) { return number_text(axis, between(axis, fraction)); }

double axis_fraction(const Axis& axis, double value) {
  const double part = axis.logarithmic ? logarithm(value / axis.from) / logarithm(axis.to / axis.from)
                                       : (value - axis.from) / (axis.to - axis.from);
  return std::clamp(part, 0.0, 1.0);
}

StudyPoint point_at(const Study& study, std::span<const double> fractions) {
  StudyPoint point{study.places.front().name, study.settings, 0};
  append(point.settings, study.places.front().settings);
  append(point.settings, drawn(study, fractions, point.settings));
  return point;
}

StudyPlan::StudyPlan(const Study& study) : study_(study) {
  const bool is_uncertain = !study.uncertain.empty();
  const auto samples = static_cast<std::size_t>(study.samples);
  const auto seed = static_cast<std::uint64_t>(study.seed);
  if (is_uncertain || study.sampling == Sampling::grid) {
    for (const Axis& axis : study.axes) {
      grid_.push_back(grid_values(axis));
      combinations_ *= grid_.back().size();
    }
  } else {
    combinations_ = samples;
    shift_ = halton_shift(study);
    const bool has_design = study.sampling != Sampling::halton && !study.axes.empty();
    if (has_design) design_.emplace(design_kind(study.sampling), static_cast<int>(study.axes.size()), samples, seed);
  }
  const int coordinates = coordinate_count(study.uncertain);
  if (is_uncertain && study.sensitivity.method != SensitivityMethod::none) {
    const StudySensitivity& sensitivity = study.sensitivity;
    points_ = sensitivity.method == SensitivityMethod::sobol
                  ? variance_points(coordinates, sensitivity.size, seed)
                  : screening_points(coordinates, sensitivity.size, sensitivity.levels, seed);
    draws_ = static_cast<std::size_t>(points_.cols());
  } else if (is_uncertain && study.sampling == Sampling::grid) {
    for (const UncertainInput& input : study.uncertain) steps_.push_back(std::get<UncertainNumber>(input).steps);
    draws_ = grid_size(steps_);
  } else if (is_uncertain) {
    draws_ = samples;
    design_.emplace(design_kind(study.sampling), coordinates, samples, seed);
  }
  regular_ = study.places.size() * combinations_ * draws_;
}

std::vector<Setting> StudyPlan::combination(std::size_t index) const {
  if (grid_.size() < study_.axes.size()) return sampled(index);
  // The last axis changes fastest.
  std::vector<Setting> settings(study_.axes.size());
  for (std::size_t i = settings.size(); i-- > 0;) {
    settings[i] = {study_.axes[i].key, grid_[i][index % grid_[i].size()]};
    index /= grid_[i].size();
  }
  return settings;
}

std::vector<Setting> StudyPlan::sampled(std::size_t index) const {
  const Eigen::VectorXd point = design_ ? design_->point(index) : Eigen::VectorXd();
  std::vector<Setting> settings;
  for (std::size_t i = 0; i < study_.axes.size(); ++i) {
    const double fraction = design_ ? point[static_cast<Eigen::Index>(i)]
                                    : shifted(radical_inverse(index, prime(static_cast<int>(i))), shift_[i]);
    settings.push_back({study_.axes[i].key, sampled_value(study_.axes[i], fraction)});
  }
  return settings;
}

std::vector<double> StudyPlan::fractions(std::size_t draw) const {
  if (study_.uncertain.empty()) return {};
  if (points_.size() > 0) {
    const auto column = points_.col(static_cast<Eigen::Index>(draw));
    return {column.begin(), column.end()};
  }
  const Eigen::VectorXd point = steps_.empty() ? design_->point(draw) : grid_point(steps_, draw);
  return {point.begin(), point.end()};
}

StudyPoint StudyPlan::point(std::size_t index) const {
  if (index >= regular_) {
    StudyPoint point = this->point(0);
    point.draw = static_cast<int>(index - regular_) + 1;
    point.settings.push_back({"solver.perturbation", fmt::format("{}", study_.ensemble.perturbation)});
    point.settings.push_back({"solver.seed", fmt::format("{}", point.draw)});
    return point;
  }
  const std::size_t group = index % group_count();
  const NamedSettings& place = study_.places[group / combinations_];
  StudyPoint point{place.name, study_.settings, 0};
  append(point.settings, place.settings);
  append(point.settings, combination(group % combinations_));
  if (!study_.uncertain.empty())
    append(point.settings, drawn(study_, fractions(index / group_count()), point.settings));
  return point;
}

}  // namespace netpocket
