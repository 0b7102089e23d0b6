#include "engine/systems/orbital_frame.h"

#include <memory>
#include <utility>

#include "engine/scenario/check_orbit.h"
#include "engine/state/channels.h"

namespace netpocket {
namespace {

void turn_with(const Eigen::Vector3d& rate, Model& model) {
  for (ModelNode& node : model.nodes) {
    if (node.support == Support::free) node.velocity += rate.cross(node.position);
  }
  for (ModelGradient& gradient : model.gradients) {
    if (gradient.support == Support::free) gradient.rate += rate.cross(gradient.value);
  }
  for (ModelBody& body : model.bodies) {
    body.state.velocity += rate.cross(body.state.position);
    body.state.angular_velocity += rate;
  }
}

void add_channels(const Orbit& orbit, CaptureSystem& system) {
  std::vector<ChannelInfo> infos(system.structure.channels->begin(), system.structure.channels->end());
  infos.push_back({"energy_tidal", "J", "work of the orbit's tide so far, a part of energy_input", ChannelKind::total});
  const bool has_way = system.spacecraft >= 0 && system.target >= 0;
  const std::size_t first = infos.size();
  if (has_way) {
    infos.push_back({"target_v_bar", "m", "target's centre from the spacecraft's along V-bar, ahead"});
    infos.push_back({"target_r_bar", "m", "the same along R-bar, to the Earth"});
    infos.push_back({"target_h_bar", "m", "the same along H-bar, against the orbit's angular momentum"});
  }
  system.structure.channels = std::make_shared<const ChannelList>(std::move(infos));
  if (!has_way) return;
  const auto craft = static_cast<std::size_t>(system.spacecraft), target = static_cast<std::size_t>(system.target);
  system.fill_channels = [of_system = std::move(system.fill_channels), first, craft, target,
                          reference = std::make_shared<ReferenceOrbit>(orbit)](const CableSystem& cables,
                                                                               Snapshot& snapshot) {
    if (of_system) of_system(cables, snapshot);
    const Eigen::Vector3d way = reference->local_axes(snapshot.time).transpose() *
                                (snapshot.bodies[target].position - snapshot.bodies[craft].position);
    for (int axis = 0; axis < 3; ++axis) snapshot.channels[first + static_cast<std::size_t>(axis)] = way[axis];
  };
}

}  // namespace

void put_into_orbit(const Scenario& scenario, CaptureSystem& system) {
  const auto orbit = orbit_of(scenario);
  if (!orbit) return;
  system.model.orbit = orbit;
  if (scenario.orbit.turns()) turn_with(ReferenceOrbit(*orbit).turning(0), system.model);
  add_channels(*orbit, system);
}

}  // namespace netpocket
