#pragma once
// The parts of a model that do not change during a run: the nodes that the elements join, the shapes of the bodies, the
// names. Together with a Snapshot it is all that drawing, exporting and reading a recording need.

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "engine/bodies/shape.h"
#include "engine/state/channels.h"
#include "engine/state/control_loop_info.h"

namespace netpocket {

// How the cables of a group are drawn.
enum class CableLook : std::uint8_t {
  cord,  // thin line
  tube,  // with its real thickness
  rope   // broad, conspicuous line
};

// Cables that are drawn, named and counted together.
struct ElementGroup {
  std::string name;    // of the group, e.g. "closing ropes"
  std::string member;  // of one member with its article, e.g. "a closing rope"
  CableLook look = CableLook::cord;

  bool operator==(const ElementGroup&) const = default;
};

// How the nodes of a group are drawn.
enum class NodeLook : std::uint8_t {
  nothing,
  joint,   // ball around a tube's node
  reel,    // spool at a tube's end, which winds a rope
  adapter,  // ring on the spacecraft on which the nodes lie
  rope      // broad line from each node to the next
};

// Nodes with a common function, in their order round the system.
struct NodeGroup {
  std::string name;  // e.g. "rod tips"
  NodeLook look = NodeLook::nothing;
  std::vector<std::int32_t> nodes;

  bool operator==(const NodeGroup&) const = default;
};

// A two-node cable element: cubic Hermite curve between node[0] and node[1] with slopes gradient[0], gradient[1]
// (dr/dp, dimensionless) over `length` metres of material. Indices are columns of Snapshot::positions / ::gradients.
struct StructureElement {
  std::int32_t node[2];
  std::int32_t gradient[2];
  std::int32_t group = 0;   // index into Structure::element_groups
  std::int32_t thread = 0;  // index into Structure::threads
  std::int32_t rope = -1;   // >= 0: variable length, current length is Snapshot::rope_element_length[rope]
  double length = 0;        // m, material length (at the start for variable elements)
  double radius = 0;        // m, outer radius of the cord or rod
};

enum class BodyRole : std::uint8_t { spacecraft = 0, target = 1, other = 2 };

struct StructureBody {
  std::string name;  // "spacecraft", "target", ...
  BodyRole role = BodyRole::other;
  Shape shape;      // for drawing and contact; body axes, origin at the centre of mass
  double mass = 0;  // kg
};

struct Structure {
  std::int32_t node_count = 0;
  std::int32_t gradient_count = 0;
  std::vector<StructureElement> elements;
  std::vector<ElementGroup> element_groups;
  std::vector<NodeGroup> node_groups;
  std::vector<std::string> threads;  // names, e.g. "rod 3", "panel 2 row 4"
  std::vector<StructureBody> bodies;
  std::int32_t rope_count = 0;                                     // variable-length ropes
  std::shared_ptr<const ChannelList> channels = known_channels();  // those of every snapshot
  std::vector<ControlLoopInfo> loops;                              // of control

  const ElementGroup& group_of(const StructureElement& element) const {
    return element_groups[static_cast<std::size_t>(element.group)];
  }
  CableLook look_of(const StructureElement& element) const { return group_of(element).look; }
  // Nodes of the group with this name; empty if there is none. The reference is valid as long as node_groups is
  // unchanged.
  const std::vector<std::int32_t>& nodes(std::string_view group) const;
  // Nodes of all groups with this look, one group after the other.
  std::vector<std::int32_t> nodes(NodeLook look) const;
};

}  // namespace netpocket
