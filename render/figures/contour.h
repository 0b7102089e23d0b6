#pragma once
// Lines of equal value on a regular grid. Pure functions: any thread may call them.

#include <Eigen/Core>
#include <vector>

namespace netpocket {

struct ContourSegment {
  Eigen::Vector2d from, to;
};

// Segments of the line on which a function has the value `level`, by marching squares with linear interpolation along
// the edges of cells. `values`: at (x[i], y[j]) in column i, row j, finite. A saddle is decided by the mean of its
// corners.
std::vector<ContourSegment> contour(const std::vector<double>& x, const std::vector<double>& y,
                                    const Eigen::MatrixXd& values, double level);

}  // namespace netpocket
