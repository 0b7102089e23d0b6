#include "engine/study/optimisation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/sampling/normal.h"
#include "engine/statistics/empirical_distribution.h"
#include "engine/statistics/evolution_strategy.h"
#include "engine/statistics/proportion.h"
#include "engine/study/study_plan.h"
#include "engine/study/study_table.h"

namespace netpocket {
namespace {

constexpr double kUnknownValue = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinite = std::numeric_limits<double>::infinity();

std::size_t draw_count(const Study& study) {
  return study.uncertain.empty() ? 1 : static_cast<std::size_t>(study.samples);
}

// The study at the values of a candidate, the draws of which are its points.
Study study_of(const Study& study, const std::vector<Setting>& settings) {
  Study candidate = study;
  candidate.optimisation = {};
  candidate.settings.insert(candidate.settings.end(), settings.begin(), settings.end());
  return candidate;
}

void add_points(std::vector<StudyPoint>& points, const Study& study, const std::string& place) {
  const StudyPlan plan(study);
  for (std::size_t draw = 0; draw < plan.draw_count(); ++draw) {
    points.push_back(plan.point(draw));
    points.back().place = place;
  }
}

bool has_failed(const StudyRecord& record) { return record["outcome"] == "diverged" || record["outcome"] == "limited"; }

// Finite numbers of a column, by draw.
std::vector<double> numbers_of(std::span<const StudyRecord> records, const std::string& column) {
  std::vector<double> numbers;
  for (const StudyRecord& record : records) {
    for (const StudyRecord& run : record["runs"]) {
      const double number = run_number(run, column);
      if (std::isfinite(number)) numbers.push_back(number);
    }
  }
  return numbers;
}

double mean_of(const std::vector<double>& numbers) {
  double sum = 0;
  for (const double number : numbers) sum += number;
  return sum / static_cast<double>(numbers.size());
}

double value_over(std::span<const StudyRecord> records, const ColumnOverDraws& of) {
  const std::vector<double> numbers = numbers_of(records, of.column);
  if (numbers.empty()) return kUnknownValue;
  return of.fraction ? EmpiricalDistribution(numbers).quantile(*of.fraction) : mean_of(numbers);
}

// The interval of a mean is that of the central limit theorem.
EstimatedValue estimate_over(std::span<const StudyRecord> records, const ColumnOverDraws& of, double confidence) {
  const std::vector<double> numbers = numbers_of(records, of.column);
  if (numbers.empty()) return {kUnknownValue, {-kInfinite, kInfinite}};
  if (of.fraction) {
    const QuantileEstimate estimate = EmpiricalDistribution(numbers).quantile_estimate(*of.fraction, confidence);
    return {estimate.value, estimate.interval};
  }
  const auto count = static_cast<std::int64_t>(numbers.size());
  const double mean = mean_of(numbers);
  if (of.column == "captured") {
    const auto captured = static_cast<std::int64_t>(std::ranges::count(numbers, 1.0));
    return {mean, wilson_interval(captured, count, confidence)};
  }
  double squares = 0;
  for (const double number : numbers) squares += (number - mean) * (number - mean);
  const double error = std::sqrt(squares / static_cast<double>(std::max<std::int64_t>(count - 1, 1) * count));
  const double half = normal_quantile((1 + confidence) / 2) * error;
  return {mean, {mean - half, mean + half}};
}

double violation_of(const StudyConstraint& constraint, double value) {
  const auto part = [](double missing, double limit) {
    return std::max(0.0, missing) / (limit == 0 ? 1 : std::abs(limit));
  };
  double sum = 0;
  if (constraint.at_most) sum += part(value - *constraint.at_most, *constraint.at_most);
  if (constraint.at_least) sum += part(*constraint.at_least - value, *constraint.at_least);
  return sum;
}

void judge(const Study& study, std::span<const StudyRecord> records, Candidate& candidate) {
  const StudyOptimisation& search = study.optimisation;
  candidate.objective = value_over(records, search.objective);
  const bool is_judged = std::isfinite(candidate.objective) && std::ranges::none_of(records, has_failed);
  candidate.violation = is_judged ? 0 : kInfinite;
  for (const StudyConstraint& constraint : search.constraints) {
    candidate.constraints.push_back(value_over(records, constraint.value));
    const double violation = violation_of(constraint, candidate.constraints.back());
    candidate.violation += std::isnan(candidate.constraints.back()) ? kInfinite : violation;
  }
}

// A number that is smaller the better a candidate is.
double rank_value(const Study& study, const Candidate& candidate) {
  constexpr double kFarFromAnyObjective = 1e100;
  if (!candidate.is_feasible()) return kFarFromAnyObjective * (1 + candidate.violation);
  return study.optimisation.is_maximised ? -candidate.objective : candidate.objective;
}

class Search {
 public:
  Search(const Study& study, const RunPoints& run) : study_(study), run_(run) {}

  Optimisation run() {
    add({base_candidate()});
    const StudyOptimisation& search = study_.optimisation;
    const auto n = static_cast<Eigen::Index>(search.over.size());
    MinimisationOptions options;
    options.lower = Eigen::VectorXd::Zero(n);
    options.upper = Eigen::VectorXd::Ones(n);
    options.start = start();
    options.step = search.step;
    options.population = search.population;
    options.most_evaluations = search.candidates;
    options.most_restarts = search.restarts;
    options.least_step = search.least_step;
    options.seed = static_cast<std::uint64_t>(study_.seed);
    const Minimum minimum = minimise([this](const Eigen::MatrixXd& points) { return evaluate(points); }, options);
    result_.restarts = minimum.restarts;
    if (!study_.uncertain.empty()) check();
    return std::move(result_);
  }

 private:
  Scenario base() const {
    Scenario scenario = study_.base;
    apply_settings(scenario, study_.settings);
    return scenario;
  }

  Candidate base_candidate() const {
    const Scenario scenario = base();
    Candidate candidate;
    for (const Axis& axis : study_.optimisation.over) {
      candidate.settings.push_back({axis.key, value_of(scenario, axis.key)});
    }
    return candidate;
  }

  // The base's values; those outside their range at its nearer end.
  Eigen::VectorXd start() const {
    const Scenario scenario = base();
    Eigen::VectorXd fractions(static_cast<Eigen::Index>(study_.optimisation.over.size()));
    for (Eigen::Index i = 0; i < fractions.size(); ++i) {
      const Axis& axis = study_.optimisation.over[static_cast<std::size_t>(i)];
      fractions[i] = axis_fraction(axis, number_of(scenario, axis.key).value_or(axis.from));
    }
    return fractions;
  }

  Eigen::VectorXd evaluate(const Eigen::MatrixXd& points) {
    ++generation_;
    std::vector<Candidate> candidates(static_cast<std::size_t>(points.cols()));
    for (std::size_t c = 0; c < candidates.size(); ++c) {
      candidates[c].generation = generation_;
      for (std::size_t i = 0; i < study_.optimisation.over.size(); ++i) {
        const Axis& axis = study_.optimisation.over[i];
        const double fraction = points(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(c));
        candidates[c].settings.push_back({axis.key, axis_value(axis, fraction)});
      }
    }
    add(std::move(candidates));
    Eigen::VectorXd values(points.cols());
    const std::size_t first = result_.candidates.size() - static_cast<std::size_t>(points.cols());
    for (Eigen::Index c = 0; c < values.size(); ++c) {
      values[c] = rank_value(study_, result_.candidates[first + static_cast<std::size_t>(c)]);
    }
    return values;
  }

  // Runs candidates side by side.
  void add(std::vector<Candidate> candidates) {
    std::vector<StudyPoint> points;
    for (std::size_t c = 0; c < candidates.size(); ++c) {
      const std::size_t number = result_.candidates.size() + c;
      add_points(points, study_of(study_, candidates[c].settings),
                 number == 0 ? "base" : fmt::format("candidate {}", number));
    }
    const std::vector<StudyRecord> records = run_(points);
    const std::size_t draws = draw_count(study_);
    for (std::size_t c = 0; c < candidates.size(); ++c) {
      judge(study_, std::span(records).subspan(c * draws, draws), candidates[c]);
      result_.candidates.push_back(std::move(candidates[c]));
      const Candidate &last = result_.candidates.back(), &best = result_.candidates[result_.best];
      if (rank_value(study_, last) < rank_value(study_, best)) result_.best = result_.candidates.size() - 1;
    }
  }

  // Independent draws, of another seed, for which the intervals hold.
  void check() {
    std::vector<StudyPoint> points;
    const auto count = static_cast<std::size_t>(study_.optimisation.check);
    for (const auto& [candidate, place] :
         {std::pair(std::size_t{0}, "base, checked"), {result_.best, "best, checked"}}) {
      Study fresh = study_of(study_, result_.candidates[candidate].settings);
      fresh.sampling = Sampling::monte_carlo;
      fresh.samples = study_.optimisation.check;
      fresh.seed = study_.seed + 1;
      add_points(points, fresh, place);
    }
    const std::vector<StudyRecord> records = run_(points);
    result_.before = estimates_of(std::span(records).first(count));
    result_.after = estimates_of(std::span(records).last(count));
  }

  std::vector<EstimatedValue> estimates_of(std::span<const StudyRecord> records) const {
    const double confidence = study_.estimate.confidence;
    std::vector<EstimatedValue> list = {estimate_over(records, study_.optimisation.objective, confidence)};
    for (const StudyConstraint& constraint : study_.optimisation.constraints) {
      list.push_back(estimate_over(records, constraint.value, confidence));
    }
    return list;
  }

  const Study& study_;
  const RunPoints& run_;
  Optimisation result_;
  int generation_ = 0;
};

}  // namespace

std::size_t planned_points(const Study& study) {
  const StudyOptimisation& search = study.optimisation;
  const int dimensions = static_cast<int>(search.over.size());
  const int population = search.population > 0 ? search.population : default_population(dimensions);
  const int generations = (search.candidates + population - 1) / population;
  const auto candidates = static_cast<std::size_t>(1 + generations * population);
  const auto check = study.uncertain.empty() ? std::size_t{0} : 2 * static_cast<std::size_t>(search.check);
  return candidates * draw_count(study) + check;
}

Optimisation optimise(const Study& study, const RunPoints& run) { return Search(study, run).run(); }

Scenario best_scenario(const Study& study, const Optimisation& result) {
  Scenario scenario = study.base;
  apply_settings(scenario, study.settings);
  apply_settings(scenario, study.places.front().settings);
  apply_settings(scenario, result.candidates[result.best].settings);
  return scenario;
}

}  // namespace netpocket
