#include "engine/systems/pocket/pocket_channels.h"

#include <algorithm>

#include "engine/math/elementary.h"
#include "engine/state/pocket_groups.h"

namespace netpocket {
namespace {

struct Mouth {
  double side = 0;       // m, mean distance between adjacent tips
  double side_rate = 0;  // m/s
  double radius = 0;     // m, mean distance of the tips from their centre
};

Mouth measure_mouth(const Snapshot& snapshot, const std::vector<std::int32_t>& tips) {
  Mouth mouth;
  const auto count = tips.size();
  if (count == 0) return mouth;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  for (const std::int32_t tip : tips) centre += snapshot.positions.col(tip) / static_cast<double>(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::int32_t a = tips[i], b = tips[(i + 1) % count];
    const Eigen::Vector3d span = snapshot.positions.col(b) - snapshot.positions.col(a);
    const double length = span.norm();
    mouth.side += length / static_cast<double>(count);
    mouth.side_rate +=
        span.dot(snapshot.velocities.col(b) - snapshot.velocities.col(a)) / length / static_cast<double>(count);
    mouth.radius += (snapshot.positions.col(a) - centre).norm() / static_cast<double>(count);
  }
  return mouth;
}

// Radius of a polyline of points (radius, height) at a height; negative outside its heights.
double radius_at(const std::vector<Eigen::Vector2d>& outline, double height) {
  for (std::size_t i = 0; i + 1 < outline.size(); ++i) {
    const double below = outline[i].y(), above = outline[i + 1].y();
    if (height < below || height > above || above == below) continue;
    const double part = (height - below) / (above - below);
    return (1 - part) * outline[i].x() + part * outline[i + 1].x();
  }
  return -1;
}

}  // namespace

PocketChannels::PocketChannels(const Pocket& pocket)
    : spacecraft_(pocket.spacecraft),
      target_(pocket.target),
      roots_(pocket.structure.nodes(kRodRoots)),
      kinks_(pocket.structure.nodes(kRodKinks)),
      tips_(pocket.structure.nodes(kRodTips)) {
  for (std::size_t i = 0; i < pocket.structure.elements.size(); ++i) {
    const std::int32_t group = pocket.structure.elements[i].group;
    if (group == index_of(PocketGroup::net)) net_.push_back(static_cast<std::int32_t>(i));
    if (group == index_of(PocketGroup::closing_ropes)) closing_ropes_.push_back(static_cast<std::int32_t>(i));
  }
}

// Whether the target's centre lies between root and mouth, and nearer to the pocket's axis than the rods at its height.
// Heights and radii are in the spacecraft's axes. Rods are polylines through their mean root, kink and tip.
bool PocketChannels::target_is_inside(const Snapshot& snapshot) const {
  const BodyState& craft = snapshot.bodies[static_cast<std::size_t>(spacecraft_)];
  const auto to_craft = [&](const Eigen::Vector3d& point) -> Eigen::Vector3d {
    return craft.attitude.conjugate() * (point - craft.position);
  };
  const auto mean = [&](const std::vector<std::int32_t>& nodes) -> Eigen::Vector2d {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (const std::int32_t node : nodes) {
      const Eigen::Vector3d p = to_craft(snapshot.positions.col(node));
      sum += Eigen::Vector2d(hypotenuse(p.x(), p.z()), p.y());
    }
    return sum / static_cast<double>(nodes.size());
  };
  if (tips_.empty()) return false;
  const Eigen::Vector3d centre = to_craft(snapshot.bodies[static_cast<std::size_t>(target_)].position);
  const double radius = radius_at({mean(roots_), mean(kinks_), mean(tips_)}, centre.y());
  return hypotenuse(centre.x(), centre.z()) < radius;
}

void PocketChannels::fill_tensions(Snapshot& snapshot) const {
  double largest = 0, sum = 0;
  for (const std::int32_t element : net_) largest = std::max(largest, snapshot.tension[element]);
  for (const std::int32_t element : closing_ropes_) sum += snapshot.tension[element];
  snapshot.channel(Channel::rope_tension_max) = largest;
  snapshot.channel(Channel::closing_tension) =
      closing_ropes_.empty() ? 0 : sum / static_cast<double>(closing_ropes_.size());
}

void PocketChannels::fill(const CableSystem& system, Snapshot& snapshot) const {
  const Mouth mouth = measure_mouth(snapshot, tips_);
  snapshot.channel(Channel::closing_length) = mouth.side;
  snapshot.channel(Channel::closing_speed) = mouth.side_rate;
  snapshot.channel(Channel::mouth_radius) = mouth.radius;
  const RopeMotion& rope = system.rope_motion(0);
  snapshot.channel(Channel::commanded_length) = rope.length;
  snapshot.channel(Channel::commanded_speed) = rope.rate;
  snapshot.channel(Channel::target_inside) = target_is_inside(snapshot) ? 1 : 0;
  fill_tensions(snapshot);
}

}  // namespace netpocket
