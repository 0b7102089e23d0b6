#pragma once
// A function that is evaluated at many points together, because the points are simulations that run side by side.

#include <Eigen/Core>
#include <functional>

namespace netpocket {

// Gets one point per column, returns one value per point.
using BatchFunction = std::function<Eigen::VectorXd(const Eigen::MatrixXd& points)>;

}  // namespace netpocket
