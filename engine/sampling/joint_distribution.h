#pragma once
// Distributions of several inputs together: correlated normal numbers and directions. Pure functions: any thread may
// call them.

#include <Eigen/Core>
#include <string>

namespace netpocket {

struct CorrelatedNormals {
  Eigen::VectorXd mean;
  Eigen::VectorXd deviation;    // standard deviations, each > 0
  Eigen::MatrixXd correlation;  // symmetric, ones on the diagonal, positive definite
};

// What is wrong, as in distribution.h. Empty if nothing is.
std::string find_fault(const CorrelatedNormals& group);

// One value per input for a point of the unit cube of as many dimensions: mean + D L z, where L L^T is the Cholesky
// factorisation of the correlation, D the deviations, and z the normal quantiles of the fractions. `group` must be
// without fault.
Eigen::VectorXd correlated_values(const CorrelatedNormals& group, const Eigen::VectorXd& fractions);

// Unit vector, evenly distributed over the sphere for a point of the unit square: the z coordinate of such a vector is
// uniform on [-1, 1] (Archimedes), the angle about z on [0, 2 pi).
Eigen::Vector3d direction(double height_fraction, double angle_fraction);

}  // namespace netpocket
