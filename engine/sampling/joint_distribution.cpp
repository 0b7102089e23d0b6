#include "engine/sampling/joint_distribution.h"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <cmath>
#include <numbers>

#include "engine/math/elementary.h"
#include "engine/sampling/distribution.h"

namespace netpocket {
namespace {

std::string fault_of_correlation(const Eigen::MatrixXd& correlation) {
  constexpr double kTolerance = 1e-12;
  if ((correlation - correlation.transpose()).cwiseAbs().maxCoeff() > kTolerance) {
    return "needs a symmetric correlation matrix";
  }
  if ((correlation.diagonal().array() - 1).abs().maxCoeff() > kTolerance) {
    return "needs a correlation matrix with ones on its diagonal";
  }
  const bool is_definite = correlation.llt().info() == Eigen::Success;
  return is_definite ? "" : "has a correlation matrix that is not positive definite: no such inputs exist";
}

}  // namespace

std::string find_fault(const CorrelatedNormals& group) {
  const Eigen::Index size = group.mean.size();
  if (size == 0) return "needs at least one input";
  if (group.deviation.size() != size || group.correlation.rows() != size || group.correlation.cols() != size) {
    return fmt::format("needs {0} deviations and {0} x {0} correlations, one for each mean", size);
  }
  if (!group.mean.allFinite() || !group.deviation.allFinite() || !group.correlation.allFinite()) {
    return "has a number that is not finite";
  }
  if (!(group.deviation.minCoeff() > 0)) {
    return fmt::format("needs a deviation > 0, not {:g}", group.deviation.minCoeff());
  }
  return fault_of_correlation(group.correlation);
}

Eigen::VectorXd correlated_values(const CorrelatedNormals& group, const Eigen::VectorXd& fractions) {
  const Eigen::VectorXd z = fractions.unaryExpr([](double u) { return quantile(Normal{}, u); });
  const Eigen::VectorXd correlated = group.correlation.llt().matrixL() * z;
  return group.mean + group.deviation.cwiseProduct(correlated);
}

Eigen::Vector3d direction(double height_fraction, double angle_fraction) {
  const double height = 2 * height_fraction - 1;
  const double radius = std::sqrt((1 - height) * (1 + height));
  const double angle = 2 * std::numbers::pi * angle_fraction;
  return {radius * cosine(angle), radius * sine(angle), height};
}

}  // namespace netpocket
