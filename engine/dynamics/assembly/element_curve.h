#pragma once
// Points and bounds of an element's curve, as contact needs them. World frame, m.

#include <Eigen/Geometry>
#include <array>
#include <cstdint>

#include "engine/dynamics/assembly/coordinate_vectors.h"

namespace netpocket {

// Coordinates of an element, or weights of these: position1, gradient1, position2, gradient2.
using ElementIndices = std::array<std::int32_t, 4>;
using ElementWeights = std::array<double, 4>;

// Point of the curve, or its velocity, for the given shape functions. With this order of summation an element that is
// turned end for end gives the same result to the last bit. `vectors`: CoordinateVectors or a type with its get().
template <typename Vectors>
[[gnu::always_inline]] inline Eigen::Vector3d combine(const Vectors& vectors, const ElementIndices& coordinate,
                                                      const ElementWeights& weight) {
  return (weight[0] * vectors.get(coordinate[0]) + weight[1] * vectors.get(coordinate[1])) +
         (weight[2] * vectors.get(coordinate[2]) + weight[3] * vectors.get(coordinate[3]));
}

// Bounding box of an element with this length and radius (m). The curve lies within the control polygon of its Bezier
// form.
inline Eigen::AlignedBox3d curve_bounds(const CoordinateVectors& coordinates, const ElementIndices& coordinate,
                                        double length, double radius) {
  const Eigen::Vector3d r1 = coordinates.get(coordinate[0]), r2 = coordinates.get(coordinate[2]);
  Eigen::AlignedBox3d box(r1);
  box.extend(r2);
  box.extend(Eigen::Vector3d(r1 + length / 3 * coordinates.get(coordinate[1])));
  box.extend(Eigen::Vector3d(r2 - length / 3 * coordinates.get(coordinate[3])));
  return {box.min().array() - radius, box.max().array() + radius};
}

// Whether a box is finite and within 1e9 m. Between two checks for faults a diverging state may take any value, and the
// broad phase fails on NaN and overflow.
inline bool is_sound(const Eigen::AlignedBox3d& box) {
  constexpr double kFarthest = 1e9;  // m
  return box.min().allFinite() && box.max().allFinite() && box.min().cwiseAbs().maxCoeff() < kFarthest &&
         box.max().cwiseAbs().maxCoeff() < kFarthest;
}

}  // namespace netpocket
