#pragma once
// Nearest surface points of one body for many points that move little from one question to the next, such as the
// contact points of cords. For a mesh it remembers what the last search of the tree found:
// - a point that was d away from the surface and has moved by less since cannot have reached it;
// - for as long as a point stays within a radius r of where it was, at a distance d from the surface, the nearest
//   triangle is one of those within d + 2 r of that place.
// Memory changes the cost only: answers are those of nearest_surface_point to the last bit, whatever was asked before.
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
  // The shape must live as long as the tracker.
  SurfaceTracker(const Shape& shape, std::size_t point_count);

  // Nearest surface point of the point `index`, now at `point` (m, body axes); nothing if it is `reach` (m, >= 0) or
  // farther away. `clearance` receives its distance (m), or less if it is farther away than `reach`.
  std::optional<SurfacePoint> nearest(std::size_t index, const Eigen::Vector3d& point, double reach, double& clearance);

 private:
  static constexpr std::size_t kMostCandidates = 14;
  struct Memory {
    Eigen::Vector3d place = Eigen::Vector3d::Zero();  // of the last search
    double distance = -1;                             // m, signed, at that place
    double radius = -1;                               // m, for which the candidates hold; < 0: there are none
    std::uint32_t count = 0;
    std::array<std::int32_t, kMostCandidates> candidates{};
  };
  SurfacePoint search(Memory& memory, const Eigen::Vector3d& point, double reach) const;

  const Shape& shape_;
  const TriangleMesh* mesh_;  // null for other shapes
  std::vector<Memory> memories_;
};

}  // namespace netpocket
