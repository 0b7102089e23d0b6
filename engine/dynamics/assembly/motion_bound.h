#pragma once
// How far, or how fast, the points of all cords move at most, from the nodes and gradients alone. A curve's point is
// S_1 r_1 + S_2 g_1 + S_3 r_2 + S_4 g_2 with S_1 + S_3 = 1 and |S_2| + |S_4| = L (1 - xi^2)/4.

#include <Eigen/Core>
#include <cstdint>

#include "engine/base/divided_loop.h"
#include "engine/dynamics/assembly/coordinate_vectors.h"
#include "engine/model/model.h"

namespace netpocket {

class MotionBound {
 public:
  // Elements never become longer than they are in `model`.
  explicit MotionBound(const Model& model);

  // m/s; not a number where one of the velocities is none.
  double speed(const CoordinateVectors& velocities, const DividedLoop& loop = undivided_loop) const;
  // The same from the largest (weight |v|)^2 of positions and gradients; not a number where one of them is none.
  static double speed(double position, double gradient);
  // By coordinate: 1 of nodes, a quarter of the longest element there (m) of gradients; 0 of what only fills blocks.
  const double* weights() const { return weights_.data(); }
  // m, between two states of elements that stay as long as they are; not a number where one of the coordinates is none.
  double way(const CoordinateVectors& before, const CoordinateVectors& now,
             const DividedLoop& loop = undivided_loop) const;

 private:
  // `squares`(first, count): of the motions of `count` coordinates from `first` on.
  template <typename Squares>
  double largest(const DividedLoop& loop, const Squares& squares) const;

  std::int32_t node_count_, first_gradient_, gradient_count_;
  Eigen::Array<double, kBlockSize, Eigen::Dynamic> quarter_length_;  // m, by gradient, of the longest element there
  AlignedVector<double> weights_;
};

}  // namespace netpocket
