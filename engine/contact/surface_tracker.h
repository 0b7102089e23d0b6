#pragma once
// Nearest surface points of one body for many points that move little between calls, such as the contact points of
// cords. For a mesh it remembers the result of the last search of the tree:
// - A point at distance d from the surface that has since moved by less than d cannot have reached it.
// - As long as a point stays within a radius r of its place at the last search, where its distance was d, the nearest
//   triangle is one of those within d + 2 r of that place (the candidates).
// This memory changes the cost only. Results are those of nearest_surface_point to the last bit, independent of earlier
// calls.
//
// Thread contract: calls for different points may run at the same time.

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "engine/bodies/shape.h"
#include "engine/bodies/triangle_mesh.h"

namespace netpocket {

class SurfaceTracker {
 public:
  // The shape must outlive the tracker.
  SurfaceTracker(const Shape& shape, std::size_t point_count);

  // Nearest surface point to the point `index` (less than point_count), which is now at `point` (m, body axes). Empty
  // if its distance is `reach` (m, >= 0) or more. `clearance` receives the signed distance (m), or a lower bound of it
  // that exceeds `reach`.
  std::optional<SurfacePoint> nearest(std::size_t index, const Eigen::Vector3d& point, double reach, double& clearance);

 private:
  static constexpr std::size_t kMostCandidates = 14;
  struct Memory {
    Eigen::Vector3d place = Eigen::Vector3d::Zero();  // of the last search
    double distance = -1;                             // m, signed, at that place
    double radius = -1;                               // m, within which the candidates are valid; < 0: no candidates
    std::uint32_t count = 0;
    std::array<std::int32_t, kMostCandidates> candidates{};
  };
  SurfacePoint search(Memory& memory, const Eigen::Vector3d& point, double reach) const;

  const Shape& shape_;
  const TriangleMesh* mesh_;  // null for other shapes
  std::vector<Memory> memories_;
};

}  // namespace netpocket
