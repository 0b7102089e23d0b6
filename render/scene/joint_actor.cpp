#include "render/scene/joint_actor.h"

#include <algorithm>

#include "render/scene/mesh_builder.h"
#include "render/scene/surface_props.h"

namespace netpocket {
namespace {

double tube_radius(const Structure& structure) {
  const auto tube = std::ranges::find_if(structure.elements, [&](const StructureElement& element) {
    return structure.look_of(element) == CableLook::tube;
  });
  return tube == structure.elements.end() ? 0.05 : tube->radius;
}

vtkSmartPointer<vtkPolyData> joint_mesh(double radius, const Color& color) {
  MeshBuilder mesh;
  mesh.set_color(color);
  mesh.add_sphere({0, 0, 0}, 2.2 * radius, 16, 8);
  return mesh.build();
}

// A spool across the tube between two flanges; z points along the tube.
vtkSmartPointer<vtkPolyData> reel_mesh(double radius, const Color& color) {
  MeshBuilder mesh;
  mesh.set_color(color);
  const Eigen::Vector3d along = Eigen::Vector3d::UnitZ() * radius;
  mesh.add_cylinder(-3.2 * along, -2.4 * along, 1.6 * radius, 3.2 * radius, 16);
  mesh.add_cylinder(-2.4 * along, -1.2 * along, 3.2 * radius, 3.2 * radius, 16);
  mesh.add_cylinder(-1.2 * along, 1.2 * along, 2.0 * radius, 2.0 * radius, 16);
  mesh.add_cylinder(1.2 * along, 2.4 * along, 3.2 * radius, 3.2 * radius, 16);
  return mesh.build();
}

std::vector<std::int32_t> gradients_at(const Structure& structure, const std::vector<std::int32_t>& nodes) {
  std::vector<std::int32_t> gradients(nodes.size(), -1);
  for (const auto& element : structure.elements) {
    if (structure.look_of(element) != CableLook::tube) continue;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      for (const int end : {0, 1}) {
        if (element.node[end] == nodes[i]) gradients[i] = element.gradient[end];
      }
    }
  }
  return gradients;
}

}  // namespace

JointActor::JointActor(const Structure& structure, Background background)
    : structure_(structure),
      joint_nodes_(structure.nodes(NodeLook::joint)),
      reel_nodes_(structure.nodes(NodeLook::reel)),
      reel_gradients_(gradients_at(structure, reel_nodes_)),
      joints_(joint_mesh(tube_radius(structure), palette(background).joints), joint_nodes_.size()),
      reels_(reel_mesh(tube_radius(structure), palette(background).retractors), reel_nodes_.size()) {
  props_ = {make_surface(joints_.mesh(), background), make_surface(reels_.mesh(), background)};
}

void JointActor::update(const Snapshot& snapshot) {
  for (std::size_t i = 0; i < joint_nodes_.size(); ++i) {
    joints_.place(i, Eigen::Matrix3d::Identity(), snapshot.positions.col(joint_nodes_[i]));
  }
  joints_.modified();
  for (std::size_t i = 0; i < reel_nodes_.size(); ++i) {
    const Eigen::Vector3d along = reel_gradients_[i] >= 0 ? Eigen::Vector3d(snapshot.gradients.col(reel_gradients_[i]))
                                                          : Eigen::Vector3d::UnitY();
    const Eigen::Vector3d axis = along.normalized();
    const auto cross = cross_axes(axis);
    Eigen::Matrix3d axes;
    axes << cross.first, cross.second, axis;
    reels_.place(i, axes, snapshot.positions.col(reel_nodes_[i]));
  }
  reels_.modified();
}

}  // namespace netpocket
