#pragma once
// Points and bounds of an element's curve, as contact needs them. m, world axes.

#include <Eigen/Geometry>
#include <array>
#include <cstdint>

#include "engine/dynamics/assembly/coordinate_vectors.h"

namespace netpocket {

// Of an element: position1, gradient1, position2, gradient2.
using ElementIndices = std::array<std::int32_t, 4>;
using ElementWeights = std::array<double, 4>;

// The point (or its velocity) with these shape functions. In this order an element that is turned end for end gives the
// same to the last bit. `vectors`: CoordinateVectors, or what has their get().
template <typename Vectors>
[[gnu::always_inline]] inline Eigen::Vector3d combine(const Vectors& vectors, const ElementIndices& coordinate,
                                                      const ElementWeights& weight) {
  return (weight[0] * vectors.get(coordinate[0]) + weight[1] * vectors.get(coordinate[1])) +
         (weight[2] * vectors.get(coordinate[2]) + weight[3] * vectors.get(coordinate[3]));
}

// Box of a cable of this radius round an element of this length: the control polygon of the cubic's Bezier form holds
// the curve.
inline Eigen::AlignedBox3d curve_bounds(const CoordinateVectors& coordinates, const ElementIndices& coordinate,
                                        double length, double radius) {
  const Eigen::Vector3d r1 = coordinates.get(coordinate[0]), r2 = coordinates.get(coordinate[2]);
  Eigen::AlignedBox3d box(r1);
  box.extend(r2);
  box.extend(Eigen::Vector3d(r1 + length / 3 * coordinates.get(coordinate[1])));
  box.extend(Eigen::Vector3d(r2 - length / 3 * coordinates.get(coordinate[3])));
  return {box.min().array() - radius, box.max().array() + radius};
}

// Between two checks for faults a diverging state may become anything, and the broad phase does not survive numbers
// that are none or overflow.
inline bool is_sound(const Eigen::AlignedBox3d& box) {
  constexpr double kFarthest = 1e9;  // m
  return box.min().allFinite() && box.max().allFinite() && box.min().cwiseAbs().maxCoeff() < kFarthest &&
         box.max().cwiseAbs().maxCoeff() < kFarthest;
}

}  // namespace netpocket
