#include "engine/systems/pocket/pocket_channels.h"

#include <algorithm>

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

// The closing rope that is wound in farthest: ropes differ when a retractor has jammed or starts late.
const RopeMotion& shortest_rope(const CableSystem& system, std::size_t ropes) {
  std::int32_t shortest = 0;
  for (std::int32_t rope = 1; rope < static_cast<std::int32_t>(ropes); ++rope) {
    if (system.rope_motion(rope).length < system.rope_motion(shortest).length) shortest = rope;
  }
  return system.rope_motion(shortest);
}

}  // namespace

PocketChannels::PocketChannels(const Pocket& pocket) : base_(pocket.base()), target_(pocket.target), interior_(pocket) {
  for (std::size_t i = 0; i < pocket.structure.elements.size(); ++i) {
    const std::int32_t group = pocket.structure.elements[i].group;
    if (group == index_of(PocketGroup::net)) net_.push_back(static_cast<std::int32_t>(i));
    if (group == index_of(PocketGroup::closing_ropes)) closing_ropes_.push_back(static_cast<std::int32_t>(i));
  }
}

bool PocketChannels::target_is_inside(const Snapshot& snapshot) const {
  return interior_.contains_target(snapshot.bodies[static_cast<std::size_t>(base_)],
                                   snapshot.bodies[static_cast<std::size_t>(target_)],
                                   [&](std::int32_t node) -> Eigen::Vector3d { return snapshot.positions.col(node); });
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
  const Mouth mouth = measure_mouth(snapshot, interior_.tips());
  snapshot.channel(Channel::closing_length) = mouth.side;
  snapshot.channel(Channel::closing_speed) = mouth.side_rate;
  snapshot.channel(Channel::mouth_radius) = mouth.radius;
  const RopeMotion& rope = shortest_rope(system, interior_.tips().size());
  snapshot.channel(Channel::commanded_length) = rope.length;
  snapshot.channel(Channel::commanded_speed) = rope.rate;
  snapshot.channel(Channel::target_inside) = target_is_inside(snapshot) ? 1 : 0;
  fill_tensions(snapshot);
}

}  // namespace netpocket
