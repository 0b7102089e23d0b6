#pragma once
// Triangles as files contain them. Nothing is guaranteed about them. Lengths in m, unless said otherwise.

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <vector>

namespace netpocket {

using Triangle = std::array<std::int32_t, 3>;  // corners, counter-clockwise seen from outside

struct MeshData {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<Triangle> triangles;
};

// Meshes with more triangles are refused.
inline constexpr std::size_t kLargestTriangleCount = 2'000'000;
inline constexpr double kSmallestMeshExtent = 1e-2;  // m, largest edge of the bounding box
inline constexpr double kLargestMeshExtent = 1e3;    // m

// Cross product of two sides of a triangle: its outward normal times twice its area. The corners must exist.
inline Eigen::Vector3d area_vector(const MeshData& mesh, const Triangle& t) {
  const Eigen::Vector3d& origin = mesh.vertices[t[0]];
  return (mesh.vertices[t[1]] - origin).cross(mesh.vertices[t[2]] - origin);
}

inline Eigen::Vector3d centroid(const MeshData& mesh, const Triangle& t) {
  return (mesh.vertices[t[0]] + mesh.vertices[t[1]] + mesh.vertices[t[2]]) / 3;
}

}  // namespace netpocket
