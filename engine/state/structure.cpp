#include "engine/state/structure.h"

#include <algorithm>

namespace netpocket {

const std::vector<std::int32_t>& Structure::nodes(std::string_view group) const {
  static const std::vector<std::int32_t> kNone;
  const auto found = std::ranges::find(node_groups, group, &NodeGroup::name);
  return found == node_groups.end() ? kNone : found->nodes;
}

std::vector<std::int32_t> Structure::nodes(NodeLook look) const {
  std::vector<std::int32_t> all;
  for (const NodeGroup& group : node_groups) {
    if (group.look == look) all.insert(all.end(), group.nodes.begin(), group.nodes.end());
  }
  return all;
}

}  // namespace netpocket
