#include "engine/statistics/evolution_strategy.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include "engine/math/power.h"
#include "engine/sampling/random.h"

namespace netpocket {
namespace {

// Strategy parameters by table 1 of the tutorial, without negative weights (its section B.2 gives them as zero).
struct StrategyParameters {
  StrategyParameters(int dimensions, int population) {
    const double n = dimensions;
    weights.resize(population / 2);
    for (Eigen::Index i = 0; i < weights.size(); ++i) {
      weights[i] = logarithm((population + 1) / 2.0) - logarithm(static_cast<double>(i) + 1);
    }
    weights /= weights.sum();
    selection_mass = 1 / weights.squaredNorm();
    path_rate = (4 + selection_mass / n) / (n + 4 + 2 * selection_mass / n);
    step_rate = (selection_mass + 2) / (n + selection_mass + 5);
    step_damping = 1 + 2 * std::max(0.0, std::sqrt((selection_mass - 1) / (n + 1)) - 1) + step_rate;
    one_rate = 2 / ((n + 1.3) * (n + 1.3) + selection_mass);
    const double rank = 2 * (selection_mass - 2 + 1 / selection_mass) / ((n + 2) * (n + 2) + selection_mass);
    rank_rate = std::min(1 - one_rate, rank);
    expected_norm = std::sqrt(n) * (1 - 1 / (4 * n) + 1 / (21 * n * n));
  }

  Eigen::VectorXd weights;    // of the better half
  double selection_mass = 0;  // mu_eff
  double path_rate = 0, step_rate = 0, step_damping = 0, one_rate = 0, rank_rate = 0;
  double expected_norm = 0;  // of a vector of n standard normal numbers
};

// The triangular wave with period 2 that is the identity on [0, 1].
double mirrored(double x) {
  const double within = x - 2 * std::floor(x / 2);
  return within <= 1 ? within : 2 - within;
}

// One run, until it converges or the budget ends.
class StrategyRun {
 public:
  StrategyRun(const Eigen::VectorXd& start, double step, int population)
      : parameters_(static_cast<int>(start.size()), population),
        population_(population),
        mean_(start),
        step_(step),
        covariance_(Eigen::MatrixXd::Identity(start.size(), start.size())),
        axes_(covariance_),
        lengths_(Eigen::VectorXd::Ones(start.size())),
        step_path_(Eigen::VectorXd::Zero(start.size())),
        path_(step_path_) {}

  // Points of the next generation, beyond the bounds too.
  Eigen::MatrixXd ask(RandomSequence& random) {
    Eigen::MatrixXd normal(mean_.size(), population_);
    for (double& z : normal.reshaped()) z = random.normal();
    steps_ = axes_ * lengths_.asDiagonal() * normal;
    return (step_ * steps_).colwise() + mean_;
  }

  void tell(const Eigen::VectorXd& values) {
    ++generation_;
    const Eigen::MatrixXd chosen = steps_(Eigen::all, better_half(values));
    const Eigen::VectorXd move = chosen * parameters_.weights;
    mean_ += step_ * move;
    adapt_step(move);
    adapt_covariance(chosen, move);
    best_values_.push_back(values.minCoeff());
  }

  bool has_converged(double least_step) const {
    const double largest = step_ * lengths_.maxCoeff();
    return !(largest > least_step) || !(lengths_.maxCoeff() < 1e7 * lengths_.minCoeff()) || is_stagnant();
  }

 private:
  std::vector<Eigen::Index> better_half(const Eigen::VectorXd& values) const {
    std::vector<Eigen::Index> order(static_cast<std::size_t>(values.size()));
    std::iota(order.begin(), order.end(), 0);
    std::ranges::stable_sort(order, {}, [&](Eigen::Index i) { return values[i]; });
    order.resize(static_cast<std::size_t>(parameters_.weights.size()));
    return order;
  }

  // Eqs. 43 and 44: the step grows if successive moves agree.
  void adapt_step(const Eigen::VectorXd& move) {
    const double rate = parameters_.step_rate;
    const Eigen::VectorXd normal = axes_ * lengths_.cwiseInverse().asDiagonal() * (axes_.transpose() * move);
    step_path_ = (1 - rate) * step_path_ + std::sqrt(rate * (2 - rate) * parameters_.selection_mass) * normal;
    const double excess = step_path_.norm() / parameters_.expected_norm - 1;
    step_ *= power(std::numbers::e, std::min(1.0, rate / parameters_.step_damping * excess));
  }

  // Eqs. 45 and 47.
  void adapt_covariance(const Eigen::MatrixXd& chosen, const Eigen::VectorXd& move) {
    const StrategyParameters& p = parameters_;
    const auto n = static_cast<double>(mean_.size());
    const double forgotten = 1 - power(1 - p.step_rate, 2.0 * generation_);
    const bool is_steady = step_path_.norm() / std::sqrt(forgotten) < (1.4 + 2 / (n + 1)) * p.expected_norm;
    path_ *= 1 - p.path_rate;
    if (is_steady) path_ += std::sqrt(p.path_rate * (2 - p.path_rate) * p.selection_mass) * move;
    const double lost = is_steady ? 0 : p.one_rate * p.path_rate * (2 - p.path_rate);
    covariance_ *= 1 + lost - p.one_rate - p.rank_rate;
    covariance_ += p.one_rate * path_ * path_.transpose();
    covariance_ += p.rank_rate * chosen * p.weights.asDiagonal() * chosen.transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver((covariance_ + covariance_.transpose()) / 2);
    axes_ = solver.eigenvectors();
    lengths_ = solver.eigenvalues().cwiseMax(0).cwiseSqrt();
  }

  // The best values of the last generations (10 + 30 n / population: section B.3) no longer differ.
  bool is_stagnant() const {
    const auto span = static_cast<std::size_t>(10 + 30 * mean_.size() / population_);
    if (best_values_.size() < span) return false;
    const auto [least, largest] =
        std::minmax_element(best_values_.end() - static_cast<std::ptrdiff_t>(span), best_values_.end());
    return *largest - *least <= 1e-12 * std::max(1e-300, std::abs(*least));
  }

  StrategyParameters parameters_;
  int population_;
  int generation_ = 0;
  Eigen::VectorXd mean_;
  double step_;
  Eigen::MatrixXd covariance_, axes_;  // axes_, lengths_: its eigenvectors and the roots of its eigenvalues
  Eigen::VectorXd lengths_;
  Eigen::VectorXd step_path_, path_;
  Eigen::MatrixXd steps_;  // of the generation, in units of step_
  std::vector<double> best_values_;
};

class Minimisation {
 public:
  Minimisation(const BatchFunction& function, const MinimisationOptions& options)
      : function_(function), options_(options), random_(options.seed) {}

  Minimum run() {
    const auto n = static_cast<int>(options_.lower.size());
    int population = options_.population;
    if (population == 0) population = default_population(n);
    Eigen::VectorXd start = Eigen::VectorXd::Constant(n, 0.5);
    if (options_.start.size() == n) start = (options_.start - options_.lower).cwiseQuotient(range());
    for (;; ++minimum_.restarts, population *= 2) {
      search(StrategyRun(start, options_.step, population));
      if (is_done() || minimum_.restarts == options_.most_restarts) return minimum_;
      for (double& u : start) u = random_.fraction();
    }
  }

 private:
  Eigen::VectorXd range() const { return options_.upper - options_.lower; }

  bool is_done() const { return minimum_.has_reached_target || minimum_.evaluations >= options_.most_evaluations; }

  void search(StrategyRun run) {
    do {
      run.tell(evaluate(run.ask(random_)));
    } while (!is_done() && !run.has_converged(options_.least_step));
  }

  Eigen::VectorXd evaluate(const Eigen::MatrixXd& units) {
    const Eigen::MatrixXd points = (range().asDiagonal() * units.unaryExpr(&mirrored)).colwise() + options_.lower;
    Eigen::VectorXd values = function_(points);
    minimum_.evaluations += static_cast<int>(values.size());
    for (Eigen::Index i = 0; i < values.size(); ++i) {
      if (!std::isfinite(values[i])) values[i] = std::numeric_limits<double>::max();
      if (values[i] >= minimum_.value) continue;
      minimum_.value = values[i];
      minimum_.point = points.col(i);
    }
    minimum_.has_reached_target = minimum_.value <= options_.target;
    return values;
  }

  const BatchFunction& function_;
  const MinimisationOptions& options_;
  RandomSequence random_;
  Minimum minimum_;
};

}  // namespace

int default_population(int dimensions) { return 4 + static_cast<int>(3 * logarithm(dimensions)); }

Minimum minimise(const BatchFunction& function, const MinimisationOptions& options) {
  return Minimisation(function, options).run();
}

}  // namespace netpocket
