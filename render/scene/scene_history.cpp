#include "render/scene/scene_history.h"

#include <algorithm>
#include <array>

namespace netpocket {
namespace {

struct RoleChannels {
  BodyRole role;
  std::array<Channel, 3> position;
};

constexpr std::array<RoleChannels, 2> kRoles = {
    {{BodyRole::spacecraft, {Channel::spacecraft_x, Channel::spacecraft_y, Channel::spacecraft_z}},
     {BodyRole::target, {Channel::target_x, Channel::target_y, Channel::target_z}}}};

}  // namespace

std::vector<BodyPath> body_paths(const Structure& structure,
                                 const std::function<const std::vector<double>&(Channel)>& channel) {
  std::vector<BodyPath> paths;
  for (const auto& [role, position] : kRoles) {
    const auto body = std::ranges::find(structure.bodies, role, &StructureBody::role);
    if (body == structure.bodies.end()) continue;
    BodyPath path{static_cast<std::size_t>(body - structure.bodies.begin()), channel(Channel::time), {}};
    path.positions.resize(3, static_cast<Eigen::Index>(path.times.size()));
    for (int axis = 0; axis < 3; ++axis) {
      const auto& values = channel(position[axis]);
      for (std::size_t i = 0; i < path.times.size(); ++i) {
        path.positions(axis, static_cast<Eigen::Index>(i)) = values[i];
      }
    }
    paths.push_back(std::move(path));
  }
  return paths;
}

}  // namespace netpocket
