#pragma once
// Least squares with bounds: the x between `lower` and `upper` that makes |A x - b|^2 + r |x|^2 least. The small r,
// 1e-8 of the largest square of a column of A, makes the solution unique: among those that fit equally well it is the
// shortest.
//
// Active-set method (Lawson & Hanson, Solving Least Squares Problems (1974), chapter 23, with upper bounds as Stark &
// Parker 1995 have them). Each round frees the bounded variable with the steepest descent and solves for the free
// variables, fixing those that meet a bound. The number of rounds is limited; ties go to the lowest index. All sums
// have a fixed order, so the bits are the same on every processor. Pure function.

#include <Eigen/Core>

namespace netpocket {

// A variable with lower < 0 < upper is free at first; lower <= 0 <= upper must hold.
Eigen::VectorXd bounded_least_squares(const Eigen::MatrixXd& a, const Eigen::VectorXd& b, const Eigen::VectorXd& lower,
                                      const Eigen::VectorXd& upper);

}  // namespace netpocket
