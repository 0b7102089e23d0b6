#pragma once
// Divides polygons in space into triangles. Any thread may call these functions.

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace netpocket {

inline constexpr std::size_t kMostPolygonCorners = 4'096;
// Largest distance of corners from the plane of a polygon, as a fraction of its extent.
inline constexpr double kPolygonFlatness = 1e-3;

using CornerTriples = std::vector<std::array<std::int32_t, 3>>;

// Triangles that cover a plane polygon, with the same orientation. They are given as indices into `corners`, and there
// are two fewer than corners. A convex polygon becomes a fan about its first corner. Any other is triangulated by
// cutting ears in its plane: Meisters (1975), Polygons Have Ears, Am. Math. Monthly 82(6), doi:10.2307/2319703. A
// polygon with a bridge to a hole, whose corners occur twice, is allowed. If the polygon cannot be triangulated,
// returns a sentence that says why ("a face ...").
std::variant<CornerTriples, std::string> triangulate(std::span<const Eigen::Vector3d> corners);

}  // namespace netpocket
