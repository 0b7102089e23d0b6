#pragma once
// A surrogate of a function from its values at some points: ordinary Kriging with a Matern 5/2 covariance that has a
// length for each input, and noise. It suits maps of the probability of capture, where each value is 0 or 1 or the
// share of a few runs: the noise is estimated with the lengths, so that the map does not follow single runs, and the
// standard error says where points are missing. Polynomial chaos has neither, and needs high orders at the edge of
// capture. Rasmussen & Williams (2006), Gaussian Processes for Machine Learning, eqs. 2.25, 4.17, 5.8; mean estimated:
// Cressie (1993), Statistics for Spatial Data, section 3.4.5. Immutable: any thread may use it.

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <cstdint>

namespace netpocket {

// Time and memory grow with the cube and the square of the number of points. More are refused by the callers.
inline constexpr Eigen::Index kMostKrigingPoints = 1000;

struct Prediction {
  double value = 0;
  double standard_error = 0;  // of the underlying function, without the noise of single values
};

class Kriging {
 public:
  struct Settings {
    Eigen::VectorXd lengths;  // in units of the inputs
    double noise = 0;         // variance of the noise by that of the process
  };

  // `points`: of the unit cube, one column each, different ones unless there is noise. `values`: one per point, finite.
  // At least three points. The settings maximise the likelihood, with mean and variance at their best values, by CMA-ES
  // (evolution_strategy.h) within lengths of 0.02 to 10 and a noise of 1e-8 to 10.
  Kriging(const Eigen::MatrixXd& points, const Eigen::VectorXd& values, std::uint64_t seed = 1);
  // With given settings.
  Kriging(const Eigen::MatrixXd& points, const Eigen::VectorXd& values, const Settings& settings);

  const Settings& settings() const { return settings_; }
  double mean() const { return mean_; }
  double process_variance() const { return variance_; }
  double log_likelihood() const { return log_likelihood_; }

  Prediction predict(const Eigen::VectorXd& point) const;

  // Error of the prediction at each point from all others with the same settings, in closed form: Dubrule (1983), Cross
  // validation of kriging in a unique neighborhood, Math. Geol. 15(6), doi:10.1007/BF01033232.
  Eigen::VectorXd leave_one_out_errors() const;
  // 1 - mean square of these errors by the variance of the values: 1 is perfect, 0 no better than the mean.
  double leave_one_out_quality() const;

 private:
  void fit();

  Eigen::MatrixXd points_;
  Eigen::VectorXd values_;
  Settings settings_;
  Eigen::LLT<Eigen::MatrixXd> factor_;  // of the correlation of the values, with noise
  Eigen::VectorXd ones_solved_;         // correlation^-1 times a vector of ones
  Eigen::VectorXd rest_solved_;         // correlation^-1 times the values without their mean
  double mean_ = 0, variance_ = 0, log_likelihood_ = 0;
};

}  // namespace netpocket
