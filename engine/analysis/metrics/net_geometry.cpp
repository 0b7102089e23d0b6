#include "engine/analysis/metrics/net_geometry.h"

#include <algorithm>
#include <map>

#include "engine/ancf/shape_functions.h"
#include "engine/state/pocket_groups.h"

namespace netpocket {
namespace {

template <typename Condition>
std::vector<std::int32_t> elements_with(const Structure& structure, const Condition& holds) {
  std::vector<std::int32_t> found;
  for (std::size_t i = 0; i < structure.elements.size(); ++i) {
    if (holds(structure.elements[i])) found.push_back(static_cast<std::int32_t>(i));
  }
  return found;
}

// The line on which a net is towed is neither its cord nor its mouth's edge.
bool is_of_net(const Structure& structure, const StructureElement& element) {
  return is_cord_or_rope(structure, element) &&
         structure.element_groups[static_cast<std::size_t>(element.group)].name != "tether";
}

double current_length(const StructureElement& element, const Snapshot& snapshot) {
  if (element.rope < 0) return element.length;
  return snapshot.rope_element_length[static_cast<std::size_t>(element.rope)];
}

Eigen::Vector3d curve_point(const StructureElement& element, const Snapshot& snapshot, double fraction) {
  ElementCoordinates q;
  q.col(0) = snapshot.positions.col(element.node[0]);
  q.col(1) = snapshot.gradients.col(element.gradient[0]);
  q.col(2) = snapshot.positions.col(element.node[1]);
  q.col(3) = snapshot.gradients.col(element.gradient[1]);
  return combine(q, shape(2 * fraction - 1, current_length(element, snapshot)));
}

// What meets at a node.
struct NodeUse {
  int cord_ends = 0;       // ends of cord elements
  bool is_shared = false;  // by several threads, or by other cables
  std::int32_t thread = -1;

  // Whether a side of a mesh goes on through the node.
  bool is_passed() const { return cord_ends == 2 && !is_shared; }
};

std::vector<NodeUse> node_uses(const Structure& structure) {
  std::vector<NodeUse> uses(static_cast<std::size_t>(structure.node_count));
  for (const StructureElement& element : structure.elements) {
    for (const std::int32_t node : element.node) {
      NodeUse& use = uses[static_cast<std::size_t>(node)];
      if (structure.look_of(element) == CableLook::cord)
        ++use.cord_ends;
      else
        use.is_shared = true;
      if (use.thread >= 0 && use.thread != element.thread) use.is_shared = true;
      use.thread = element.thread;
    }
  }
  return uses;
}

}  // namespace

std::vector<CordSegment> cord_segments(const Structure& structure, const Snapshot& snapshot,
                                       const std::vector<std::int32_t>& chosen, int pieces) {
  std::vector<CordSegment> segments;
  segments.reserve(chosen.size() * static_cast<std::size_t>(pieces));
  for (const std::int32_t index : chosen) {
    const StructureElement& element = structure.elements[static_cast<std::size_t>(index)];
    Eigen::Vector3d from = curve_point(element, snapshot, 0);
    for (int i = 1; i <= pieces; ++i) {
      const Eigen::Vector3d to = curve_point(element, snapshot, static_cast<double>(i) / pieces);
      segments.push_back({from, to, element.radius});
      from = to;
    }
  }
  return segments;
}

std::vector<std::int32_t> net_elements(const Structure& structure) {
  return elements_with(structure, [&](const StructureElement& e) { return is_of_net(structure, e); });
}

std::vector<std::int32_t> rope_elements(const Structure& structure) {
  return elements_with(structure, [&](const StructureElement& e) {
    return is_of_net(structure, e) && structure.look_of(e) == CableLook::rope;
  });
}

std::vector<std::int32_t> net_nodes(const Structure& structure) {
  std::vector<std::int32_t> nodes;
  for (const StructureElement& element : structure.elements) {
    if (is_of_net(structure, element)) nodes.insert(nodes.end(), std::begin(element.node), std::end(element.node));
  }
  std::ranges::sort(nodes);
  nodes.erase(std::ranges::unique(nodes).begin(), nodes.end());
  return nodes;
}

double mesh_size(const Structure& structure) {
  const std::vector<NodeUse> uses = node_uses(structure);
  double length = 0, ends = 0;
  for (const StructureElement& element : structure.elements) {
    if (structure.look_of(element) != CableLook::cord) continue;
    length += element.length;
    for (const std::int32_t node : element.node) ends += uses[static_cast<std::size_t>(node)].is_passed() ? 0 : 1;
  }
  return ends > 0 ? 2 * length / ends : 0;
}

Eigen::Matrix3Xd mouth_polygon(const Structure& structure, const Snapshot& snapshot) {
  const std::vector<std::int32_t>& tips = structure.nodes(kRodTips);
  Eigen::Matrix3Xd polygon(3, static_cast<Eigen::Index>(tips.size()));
  for (std::size_t i = 0; i < tips.size(); ++i) {
    polygon.col(static_cast<Eigen::Index>(i)) = snapshot.positions.col(tips[i]);
  }
  return polygon;
}

Eigen::Vector3d vector_area(const Eigen::Matrix3Xd& polygon) {
  Eigen::Vector3d area = Eigen::Vector3d::Zero();
  for (Eigen::Index i = 1; i + 1 < polygon.cols(); ++i) {
    const Eigen::Vector3d a = polygon.col(i) - polygon.col(0), b = polygon.col(i + 1) - polygon.col(0);
    area += a.cross(b) / 2;
  }
  return area;
}

}  // namespace netpocket
