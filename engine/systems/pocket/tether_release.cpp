#include "engine/systems/pocket/tether_release.h"

#include <utility>

#include "engine/systems/tether_winch.h"

namespace netpocket {

TetherRelease::TetherRelease(const Scenario& scenario, std::int32_t hub, std::shared_ptr<const CaptureTimes> times)
    : tether_(pocket_tether(scenario)), hub_(hub), times_(std::move(times)) {}

double TetherRelease::release_time() const {
  return tether_.released_at == ReleaseEvent::time ? tether_.release_time : times_->closing_end + tether_.release_delay;
}

void TetherRelease::update(const Measurements& measurements, double /*interval*/, Commands& commands) {
  if (measurements.is_held(hub_) && measurements.time() >= release_time()) commands.release(hub_);
}

void TetherRelease::change(const Scenario& scenario, double /*now*/) { tether_ = pocket_tether(scenario); }

TetherChannels::TetherChannels(const Pocket& pocket)
    : hub_(pocket.hub), target_(pocket.target), tether_(pocket.tether) {
  if (hub_ < 0) return;
  const auto element = [&](std::int32_t index) { return pocket.model.elements[static_cast<std::size_t>(index)]; };
  if (tether_.empty()) {
    rope_ = static_cast<std::int32_t>(pocket.model.ropes.size());
    eye_ = pocket.model.ring_ropes.front().nodes.front();
    far_end_ = pocket.model.ring_ropes.front().nodes.back();
  } else {
    eye_ = element(tether_.front()).node1;
    far_end_ = element(tether_.back()).node2;
  }
  // In the order of `fill`.
  infos_ = {{"hub_held", "1", "1 while the spacecraft holds the hub on which the rods stand"},
            {"tether_tension", "N", "tension of the tether at the spacecraft"},
            {"tether_distance", "m", "distance between the ends of the tether"},
            {"hub_spin", "rad/s", "angular speed of the hub"},
            {"target_hub_distance", "m", "distance of the target's centre from the hub"},
            {"target_hub_speed", "m/s", "speed of the target's centre against the hub"}};
  if (rope_ < 0) return;
  for (const ChannelInfo& info : wound_tether_channels()) infos_.push_back(info);
}

void TetherChannels::fill(const CableSystem& system, std::size_t first, Snapshot& snapshot) const {
  if (hub_ < 0) return;
  const BodyState& hub = snapshot.bodies[static_cast<std::size_t>(hub_)];
  const BodyState& target = snapshot.bodies[static_cast<std::size_t>(target_)];
  auto out = snapshot.channels.begin() + static_cast<std::ptrdiff_t>(first);
  *out++ = system.is_held(hub_) ? 1 : 0;
  *out++ = rope_ >= 0 ? system.rope_tension(rope_) : snapshot.tension[tether_.front()] + 0.0;  // a slack one has -0
  *out++ = (snapshot.positions.col(far_end_) - snapshot.positions.col(eye_)).norm();
  *out++ = hub.angular_velocity.norm();
  *out++ = (target.position - hub.position).norm();
  *out++ = (target.velocity - hub.velocity).norm();
  if (rope_ < 0) return;
  *out++ = system.rope_motion(rope_).length;
  *out++ = system.rope_motion(rope_).rate;
}

}  // namespace netpocket
