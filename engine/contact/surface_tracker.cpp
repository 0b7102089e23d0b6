#include "engine/contact/surface_tracker.h"

#include <algorithm>

namespace netpocket {
namespace {

// Radius within which candidates are valid, over the typical edge of the mesh. It gives about as many candidates as
// triangles meet at a corner.
constexpr double kRadius = 0.1;
constexpr int kHalvings = 4;
// Slack of distances, m: well above their rounding errors and too small to matter.
constexpr double kSlack = 1e-9;

}  // namespace

SurfaceTracker::SurfaceTracker(const Shape& shape, std::size_t point_count)
    : shape_(shape), mesh_(std::holds_alternative<MeshShape>(shape) ? std::get<MeshShape>(shape).mesh.get() : nullptr) {
  if (mesh_) memories_.resize(point_count);
}

std::optional<SurfacePoint> SurfaceTracker::nearest(std::size_t index, const Eigen::Vector3d& point, double reach,
                                                    double& clearance) {
  SurfacePoint found;
  if (mesh_) {
    Memory& memory = memories_[index];
    const double moved = (point - memory.place).norm();
    clearance = memory.distance - moved;
    if (clearance > reach + kSlack) return std::nullopt;
    found = moved <= memory.radius ? mesh_->nearest_among(point, {memory.candidates.data(), memory.count})
                                   : search(memory, point, reach);
  } else {
    found = nearest_surface_point(shape_, point);
  }
  clearance = found.distance;
  return found.distance < reach ? std::optional(found) : std::nullopt;
}

SurfacePoint SurfaceTracker::search(Memory& memory, const Eigen::Vector3d& point, double reach) const {
  const SurfacePoint found = mesh_->nearest(point);
  memory.place = point;
  memory.distance = found.distance;
  memory.radius = -1;
  double radius = kRadius * mesh_->typical_edge();
  if (found.distance > reach + radius) return found;  // too far away to need candidates soon
  std::vector<std::int32_t> places;
  for (int i = 0; i < kHalvings; ++i, radius /= 2) {
    places.clear();
    const double within = std::abs(found.distance) + 2 * radius + kSlack;
    if (!mesh_->tree().collect(point, within, kMostCandidates, places)) continue;
    std::copy(places.begin(), places.end(), memory.candidates.begin());
    memory.count = static_cast<std::uint32_t>(places.size());
    memory.radius = radius;
    break;
  }
  return found;
}

}  // namespace netpocket
