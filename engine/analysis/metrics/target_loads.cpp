#include "engine/analysis/metrics/target_loads.h"

#include <array>
#include <cmath>

namespace netpocket {
namespace {

constexpr std::array<const char*, Satellite::kPartCount> kSatelliteParts = {
    "bus", "left arm", "right arm", "left panel", "right panel", "mast", "dish", "nozzle"};

// Distance of a point from a part's surface.
double distance_from(const Satellite::Part& part, const Eigen::Vector3d& point) {
  const Shape solid = std::visit([](const auto& s) { return Shape(s); }, part.solid);
  return std::abs(nearest_surface_point(solid, point - part.centre).distance);
}

}  // namespace

std::vector<std::string> part_names(const Shape& shape) {
  if (std::holds_alternative<Satellite>(shape)) return {kSatelliteParts.begin(), kSatelliteParts.end()};
  return {"body"};
}

std::string part_name(const Shape& shape, const Eigen::Vector3d& point) {
  const auto* satellite = std::get_if<Satellite>(&shape);
  if (satellite == nullptr) return "body";
  std::size_t nearest = 0;
  for (std::size_t i = 1; i < satellite->parts().size(); ++i) {
    if (distance_from(satellite->parts()[i], point) < distance_from(satellite->parts()[nearest], point)) nearest = i;
  }
  return kSatelliteParts[nearest];
}

void TargetLoads::add(const Structure& structure, const Snapshot& snapshot, std::int32_t target) {
  const Shape& shape = structure.bodies[static_cast<std::size_t>(target)].shape;
  const BodyState& body = snapshot.bodies[static_cast<std::size_t>(target)];
  std::map<std::string, Eigen::Vector3d> sums;
  for (const ContactPoint& contact : snapshot.contacts) {
    if (contact.body != target) continue;
    const Eigen::Vector3d local = body.attitude.conjugate() * (contact.position - body.position);
    sums.try_emplace(part_name(shape, local), Eigen::Vector3d::Zero()).first->second += contact.force;
  }
  for (const auto& [part, sum] : sums) {
    PartLoad& load = largest_[part];
    if (sum.norm() > load.force) load = {sum.norm(), snapshot.time};
  }
}

}  // namespace netpocket
