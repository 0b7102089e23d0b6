#pragma once
// Strain and curvature of a cable at a point, with their derivatives, from a = r' (dimensionless) and b = r'' (1/m).
// Internal to the full element.

#include "engine/ancf/full_element.h"

namespace netpocket {

// eps(a)
struct AxialStrain {
  AxialStrain(const Eigen::Vector3d& a, StrainMeasure measure);

  double value;
  Eigen::Vector3d gradient;  // d(eps)/da
};

// d2(eps)/da2
Eigen::Matrix3d axial_strain_hessian(const Eigen::Vector3d& a, StrainMeasure measure);

// kappa^2 (a, b), 1/m^2
struct SquaredCurvature {
  SquaredCurvature(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const FullElementOptions& options);

  double value;
  Eigen::Vector3d gradient_a;  // d(kappa^2)/da, 1/m^2
  Eigen::Vector3d gradient_b;  // d(kappa^2)/db, 1/m
};

struct SquaredCurvatureHessian {
  SquaredCurvatureHessian(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const FullElementOptions& options);

  Eigen::Matrix3d aa, ab, bb;  // d2(kappa^2)/da2, /dadb, /db2
};

}  // namespace netpocket
