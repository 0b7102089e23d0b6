#include "engine/ancf/strain_measure.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace netpocket {
namespace {

// |a|, bounded away from zero so that a vanishing gradient gives no force instead of 0/0.
double stretch(const Eigen::Vector3d& a) {
  return std::max(std::sqrt(squared_norm(a)), std::numeric_limits<double>::min());
}

// Weights in kappa^2 = power(A) G + spread(A) B and their derivatives by A; see full_element.h.
struct CurvatureWeights {
  CurvatureWeights(double A, const FullElementOptions& options) {
    const double n = options.measure == StrainMeasure::green ? 3 : 2;
    const double smallest = options.smallest_stretch * options.smallest_stretch;
    const double expansion_point = std::max(A, smallest);
    const double inverse = 1 / expansion_point;
    const double inverse_power = inverse * inverse * (n == 3 ? inverse : 1);
    const double y = (A - expansion_point) * inverse;  // < 0 where |a| < smallest_stretch, else 0
    power = inverse_power * (1 - n * y + n * (n + 1) / 2 * y * y);
    power_slope = -n * inverse_power * inverse * (1 - (n + 1) * y);
    power_bend = n * (n + 1) * inverse_power * inverse * inverse;
    const double scale = -n * (n + 1) / 2 * inverse_power;
    spread = scale * expansion_point * y * y * y;
    spread_slope = 3 * scale * y * y;
    spread_bend = 6 * scale * inverse * y;
  }

  double power, power_slope, power_bend;     // A^-n, or its Taylor polynomial
  double spread, spread_slope, spread_bend;  // 0 unless |a| < smallest_stretch
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
  // The cross product keeps all digits of a small curvature; A B - C^2 would lose them by cancellation.
  const Eigen::Vector3d w = a.cross(b);
  const double G = squared_norm(w), B = squared_norm(b);
  const CurvatureWeights g(squared_norm(a), options);
  value = G * g.power + B * g.spread;
  gradient_a = 2 * g.power * b.cross(w) + 2 * (G * g.power_slope + B * g.spread_slope) * a;
  gradient_b = 2 * g.power * w.cross(a) + 2 * g.spread * b;
}

SquaredCurvatureHessian::SquaredCurvatureHessian(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                                 const FullElementOptions& options) {
  const Eigen::Matrix3d one = Eigen::Matrix3d::Identity();
  const double A = squared_norm(a), B = squared_norm(b), C = dot(a, b);
  const Eigen::Vector3d w = a.cross(b);
  const double G = squared_norm(w);
  const Eigen::Vector3d G_a = 2 * b.cross(w), G_b = 2 * w.cross(a);
  const CurvatureWeights g(A, options);

  aa = 2 * g.power * (B * one - b * b.transpose()) + 2 * g.power_slope * (G_a * a.transpose() + a * G_a.transpose()) +
       2 * (G * g.power_slope + B * g.spread_slope) * one +
       4 * (G * g.power_bend + B * g.spread_bend) * a * a.transpose();
  ab = 2 * g.power * (2 * a * b.transpose() - b * a.transpose() - C * one) + 2 * g.power_slope * a * G_b.transpose() +
       4 * g.spread_slope * a * b.transpose();
  bb = 2 * g.power * (A * one - a * a.transpose()) + 2 * g.spread * one;
}

}  // namespace netpocket
