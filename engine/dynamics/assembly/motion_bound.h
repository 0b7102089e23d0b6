#pragma once
// Upper bounds of the distance and speed of the points of all cords, from nodes and gradients alone. A point of a curve
// is S_1 r_1 + S_2 g_1 + S_3 r_2 + S_4 g_2 with S_1 + S_3 = 1 and |S_2| + |S_4| = L (1 - xi^2)/4.
//
// Thread contract: immutable after construction.

#include <Eigen/Core>
#include <cstdint>

#include "engine/base/divided_loop.h"
#include "engine/dynamics/assembly/coordinate_vectors.h"
#include "engine/model/model.h"

namespace netpocket {

// The larger of two non-negative numbers; NaN if either is NaN.
inline double larger_or_none(double a, double b) { return a >= b || a != a ? a : b; }

class MotionBound {
 public:
  // Elements must never become longer than they are in `model`.
  explicit MotionBound(const Model& model);

  // Upper bound (m/s) of the speed of any point; NaN if any velocity is NaN.
  double speed(const CoordinateVectors& velocities, const DividedLoop& loop = undivided_loop) const;
  // The same bound from the largest (weight |v|)^2 of positions and of gradients; NaN if either is NaN.
  static double speed(double position, double gradient);
  // By coordinate: 1 for nodes; a quarter of the longest element there (m) for gradients; 0 for padding.
  const double* weights() const { return weights_.data(); }
  // Upper bound (m) of the displacement of any point between two states, if elements keep their lengths; NaN if any
  // coordinate is NaN.
  double way(const CoordinateVectors& before, const CoordinateVectors& now,
             const DividedLoop& loop = undivided_loop) const;

 private:
  // `squares`(first, count): squared displacements of `count` coordinates from `first` on.
  template <typename Squares>
  double largest(const DividedLoop& loop, const Squares& squares) const;

  std::int32_t node_count_, first_gradient_, gradient_count_;
  Eigen::Array<double, kBlockSize, Eigen::Dynamic> quarter_length_;  // m, by gradient: quarter of the longest element
  AlignedVector<double> weights_;
};

}  // namespace netpocket
