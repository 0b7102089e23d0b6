#include "render/output/animated_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "render/render_error.h"

namespace netpocket {
namespace {

constexpr std::uint16_t kNoJoint = std::numeric_limits<std::uint16_t>::max();
constexpr int kCrossPoints = 6;  // both ends of three bars
constexpr int kRingSides = 12;
constexpr int kRingSegments = 2;  // of an element

void append(std::vector<float>& values, const Eigen::Vector3d& vector) {
  for (int c = 0; c < 3; ++c) values.push_back(static_cast<float>(vector[c]));
}

void append_quad(std::vector<std::uint32_t>& triangles, std::uint32_t a, std::uint32_t b, std::uint32_t c,
                 std::uint32_t d) {
  triangles.insert(triangles.end(), {a, b, c, a, c, d});
}

Eigen::Vector3d first_place(const GltfTrack& joint) {
  return Eigen::Map<const Eigen::Vector3f>(joint.translations.data()).cast<double>();
}

// Both ends of three bars along the world's axes: kCrossPoints points that follow a joint.
void append_cross(GltfSkinnedPart& part, const GltfTrack& joint, std::size_t index, double half_width) {
  const Eigen::Vector3d center = first_place(joint);
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-half_width, half_width}) {
      append(part.positions, center + side * Eigen::Vector3d::Unit(axis));
    }
  }
  part.joints.insert(part.joints.end(), kCrossPoints, static_cast<std::uint16_t>(index));
}

}  // namespace

AnimatedCords::AnimatedCords(const Structure& structure)
    : structure_(structure), joint_of_(static_cast<std::size_t>(structure.node_count), kNoJoint) {
  for (const StructureElement& element : structure.elements) {
    if (structure.look_of(element) == CableLook::tube) continue;
    for (const std::int32_t node : element.node) {
      auto& joint = joint_of_[static_cast<std::size_t>(node)];
      if (joint != kNoJoint) continue;
      if (nodes_.size() == kNoJoint) throw RenderError("an animation has room for 65535 nodes of cords");
      joint = static_cast<std::uint16_t>(nodes_.size());
      nodes_.push_back(node);
      joints_.push_back({fmt::format("node {}", node), {}, {}});
    }
  }
}

void AnimatedCords::add_key(const Snapshot& snapshot) {
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const Eigen::Vector3d position = snapshot.positions.col(nodes_[i]);
    joints_[i].add(position);
    box_.extend(position);
  }
}

GltfSkinnedPart AnimatedCords::part(CableLook look, double half_width) const {
  GltfSkinnedPart part;
  std::vector<std::uint32_t> first_point(nodes_.size(), 0);
  std::vector<bool> has_points(nodes_.size(), false);
  const auto point_of = [&](std::int32_t node) {
    const std::uint16_t joint = joint_of_[static_cast<std::size_t>(node)];
    if (!has_points[joint]) {
      has_points[joint] = true;
      first_point[joint] = static_cast<std::uint32_t>(part.joints.size());
      append_cross(part, joints_[joint], joint, half_width);
    }
    return first_point[joint];
  };
  for (const StructureElement& element : structure_.elements) {
    if (structure_.look_of(element) != look) continue;
    const std::uint32_t from = point_of(element.node[0]), to = point_of(element.node[1]);
    for (std::uint32_t bar = 0; bar < kCrossPoints; bar += 2) {
      append_quad(part.triangles, from + bar, to + bar, to + bar + 1, from + bar + 1);
    }
  }
  return part;
}

void AnimatedCords::add_to(GltfDocument& document, const Palette& palette, double width) const {
  GltfSkinnedPart net = part(CableLook::cord, width / 2), ropes = part(CableLook::rope, width);
  net.color = palette.net;
  ropes.color = palette.closing_ropes;
  std::vector<GltfSkinnedPart> parts;
  for (GltfSkinnedPart* some : {&net, &ropes}) {
    if (!some->triangles.empty()) parts.push_back(std::move(*some));
  }
  if (!parts.empty()) document.add_skinned("cords", joints_, parts);
}

AnimatedRopes::AnimatedRopes(const Structure& structure) {
  for (const NodeGroup& group : structure.node_groups) {
    if (group.look != NodeLook::rope || group.nodes.size() < 2) continue;
    if (group.nodes.size() > kNoJoint) throw RenderError("an animation has room for 65535 nodes of a rope");
    Rope rope{group.name, group.nodes, {}};
    for (const std::int32_t node : group.nodes) {
      rope.joints.push_back({fmt::format("{}, node {}", group.name, node), {}, {}});
    }
    ropes_.push_back(std::move(rope));
  }
}

void AnimatedRopes::add_key(const Snapshot& snapshot) {
  for (Rope& rope : ropes_) {
    for (std::size_t i = 0; i < rope.nodes.size(); ++i) {
      const Eigen::Vector3d position = snapshot.positions.col(rope.nodes[i]);
      rope.joints[i].add(position);
      box_.extend(position);
    }
  }
}

void AnimatedRopes::add_to(GltfDocument& document, const Palette& palette, double width) const {
  for (const Rope& rope : ropes_) {
    GltfSkinnedPart part;
    part.color = palette.closing_ropes;
    for (std::size_t i = 0; i < rope.joints.size(); ++i) append_cross(part, rope.joints[i], i, width / 2);
    for (std::size_t i = 0; i + 1 < rope.joints.size(); ++i) {
      const auto from = static_cast<std::uint32_t>(i * kCrossPoints), to = from + kCrossPoints;
      // What each edge of the octahedron sweeps: between all of its corners that are no two ends of a bar.
      for (std::uint32_t a = 0; a < kCrossPoints; ++a) {
        for (std::uint32_t b = a + 1; b < kCrossPoints; ++b) {
          if (a / 2 != b / 2) append_quad(part.triangles, from + a, to + a, to + b, from + b);
        }
      }
    }
    document.add_skinned(rope.name, rope.joints, {part});
  }
}

AnimatedTubes::AnimatedTubes(const Structure& structure) : structure_(structure), curve_(kRingSegments) {
  const StructureElement* previous = nullptr;
  for (std::size_t i = 0; i < structure.elements.size(); ++i) {
    const StructureElement& element = structure.elements[i];
    if (structure.look_of(element) != CableLook::tube) continue;
    // Neighbours share the ring between them; at a kink a new tube begins.
    const bool continues = previous && previous->gradient[1] == element.gradient[0];
    if (continues) rings_.back().continued = true;
    for (int place = continues ? 1 : 0; place <= kRingSegments; ++place) {
      rings_.push_back({i, place, place < kRingSegments});
    }
    previous = &element;
  }
  for (std::size_t i = 0; i < rings_.size(); ++i) joints_.push_back({fmt::format("ring {}", i), {}, {}});
}

// Each ring turns from the one before it as little as possible, the first of a tube from the world's axes.
void AnimatedTubes::add_key(const Snapshot& snapshot) {
  Eigen::Quaterniond attitude = Eigen::Quaterniond::Identity();
  bool begins = true;
  for (std::size_t i = 0; i < rings_.size(); ++i) {
    const CurvePoint center = curve_.at(snapshot, structure_.elements[rings_[i].element], rings_[i].place);
    if (begins) attitude.setIdentity();
    attitude = Eigen::Quaterniond::FromTwoVectors(attitude * Eigen::Vector3d::UnitY(), center.tangent) * attitude;
    joints_[i].add(center.position, attitude);
    begins = !rings_[i].continued;
  }
}

void AnimatedTubes::add_to(GltfDocument& document, const Palette& palette) const {
  if (rings_.empty()) return;
  GltfSkinnedPart part;
  part.color = palette.rods;
  for (std::size_t i = 0; i < rings_.size(); ++i) {
    const double radius = structure_.elements[rings_[i].element].radius;
    const Eigen::Vector3d center = first_place(joints_[i]);
    const Eigen::Quaterniond attitude = Eigen::Quaternionf(joints_[i].rotations.data()).cast<double>();
    for (int side = 0; side < kRingSides; ++side) {
      const double angle = 2 * std::numbers::pi * side / kRingSides;
      const Eigen::Vector3d normal = attitude * Eigen::Vector3d(std::sin(angle), 0, std::cos(angle));
      append(part.positions, center + radius * normal);
      append(part.normals, normal);
      part.joints.push_back(static_cast<std::uint16_t>(i));
    }
    if (!rings_[i].continued) continue;
    const auto here = static_cast<std::uint32_t>(i * kRingSides);
    for (std::uint32_t side = 0; side < kRingSides; ++side) {
      const std::uint32_t a = here + side, b = here + (side + 1) % kRingSides;
      append_quad(part.triangles, a, b, b + kRingSides, a + kRingSides);
    }
  }
  document.add_skinned("rods", joints_, {part});
}

}  // namespace netpocket
