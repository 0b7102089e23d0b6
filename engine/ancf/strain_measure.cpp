#include "engine/ancf/strain_measure.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace netpocket {
namespace {

// |a|, kept from zero so that a vanishing gradient has no direction and gives no force.
double stretch(const Eigen::Vector3d& a) {
  return std::max(std::sqrt(squared_norm(a)), std::numeric_limits<double>::min());
}

// A^-n and its derivatives by A; n = 3 (green) or 2 (material). Below the smallest stretch its Taylor polynomial.
struct InversePower {
  InversePower(double A, const FullElementOptions& options) {
    const double n = options.measure == StrainMeasure::green ? 3 : 2;
    const double expansion_point = std::max(A, options.smallest_stretch * options.smallest_stretch);
    const double power = 1 / (expansion_point * expansion_point * (n == 3 ? expansion_point : 1));
    const double step = A - expansion_point;
    const double slope = -n * power / expansion_point;
    second = -(n + 1) * slope / expansion_point;
    first = slope + second * step;
    value = power + slope * step + second * step * step / 2;
  }

  double value, first, second;
};

}  // namespace

AxialStrain::AxialStrain(const Eigen::Vector3d& a, StrainMeasure measure) {
  if (measure == StrainMeasure::green) {
    value = (squared_norm(a) - 1) / 2;
    gradient = a;
  } else {
    const double length = stretch(a);
    value = length - 1;
    gradient = a / length;
  }
}

Eigen::Matrix3d axial_strain_hessian(const Eigen::Vector3d& a, StrainMeasure measure) {
  if (measure == StrainMeasure::green) return Eigen::Matrix3d::Identity();
  const double length = stretch(a);
  const Eigen::Vector3d t = a / length;
  return (Eigen::Matrix3d::Identity() - t * t.transpose()) / length;
}

SquaredCurvature::SquaredCurvature(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                   const FullElementOptions& options) {
  // The cross product keeps all digits of a small curvature; A B - C^2 would cancel them.
  const Eigen::Vector3d w = a.cross(b);
  const double G = squared_norm(w);
  const InversePower g(squared_norm(a), options);
  value = G * g.value;
  gradient_a = 2 * g.value * b.cross(w) + 2 * G * g.first * a;
  gradient_b = 2 * g.value * w.cross(a);
}

SquaredCurvatureHessian::SquaredCurvatureHessian(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                                 const FullElementOptions& options) {
  const Eigen::Matrix3d one = Eigen::Matrix3d::Identity();
  const double A = squared_norm(a), B = squared_norm(b), C = dot(a, b);
  const Eigen::Vector3d w = a.cross(b);
  const double G = squared_norm(w);
  const Eigen::Vector3d G_a = 2 * b.cross(w), G_b = 2 * w.cross(a);
  const InversePower g(A, options);

  aa = 2 * g.value * (B * one - b * b.transpose()) + 2 * g.first * (G_a * a.transpose() + a * G_a.transpose()) +
       2 * G * g.first * one + 4 * G * g.second * a * a.transpose();
  ab = 2 * g.value * (2 * a * b.transpose() - b * a.transpose() - C * one) + 2 * g.first * a * G_b.transpose();
  bb = 2 * g.value * (A * one - a * a.transpose());
}

}  // namespace netpocket
