#pragma once
// Polygons in space as triangles. Any thread may call these functions.

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace netpocket {

inline constexpr std::size_t kMostPolygonCorners = 4'096;
// How far corners may lie off the plane of a polygon, of its extent.
inline constexpr double kPolygonFlatness = 1e-3;

using CornerTriples = std::vector<std::array<std::int32_t, 3>>;

// Triangles that cover a plane polygon and run round as it does, as places in the list of corners; two fewer than
// corners. A convex polygon becomes a fan about its first corner; from any other, ears are cut off in its plane:
// Meisters (1975), Polygons Have Ears, Am. Math. Monthly 82(6), doi:10.2307/2319703. A bridge to a hole, whose corners
// are there twice, is a polygon, too. Otherwise what is wrong: "a face ...".
std::variant<CornerTriples, std::string> triangulate(std::span<const Eigen::Vector3d> corners);

}  // namespace netpocket
