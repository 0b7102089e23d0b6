#include "render/scene/joint_actor.h"

#include <algorithm>

#include "render/scene/mesh_builder.h"
#include "render/scene/surface_props.h"

namespace netpocket {
namespace {

double rod_radius(const Structure& structure) {
  const auto rod = std::ranges::find(structure.elements, ElementKind::rod, &StructureElement::kind);
  return rod == structure.elements.end() ? 0.05 : rod->radius;
}

vtkSmartPointer<vtkPolyData> kink_mesh(double radius, const Color& color) {
  MeshBuilder mesh;
  mesh.set_color(color);
  mesh.add_sphere({0, 0, 0}, 2.2 * radius, 16, 8);
  return mesh.build();
}

// A spool across the rod between two flanges; z points along the rod.
vtkSmartPointer<vtkPolyData> retractor_mesh(double radius, const Color& color) {
  MeshBuilder mesh;
  mesh.set_color(color);
  const Eigen::Vector3d along = Eigen::Vector3d::UnitZ() * radius;
  mesh.add_cylinder(-3.2 * along, -2.4 * along, 1.6 * radius, 3.2 * radius, 16);
  mesh.add_cylinder(-2.4 * along, -1.2 * along, 3.2 * radius, 3.2 * radius, 16);
  mesh.add_cylinder(-1.2 * along, 1.2 * along, 2.0 * radius, 2.0 * radius, 16);
  mesh.add_cylinder(1.2 * along, 2.4 * along, 3.2 * radius, 3.2 * radius, 16);
  return mesh.build();
}

std::vector<std::int32_t> gradients_at(const Structure& structure, const std::vector<std::int32_t>& tips) {
  std::vector<std::int32_t> gradients(tips.size(), -1);
  for (const auto& element : structure.elements) {
    if (element.kind != ElementKind::rod) continue;
    for (std::size_t i = 0; i < tips.size(); ++i) {
      for (const int end : {0, 1}) {
        if (element.node[end] == tips[i]) gradients[i] = element.gradient[end];
      }
    }
  }
  return gradients;
}

}  // namespace

JointActor::JointActor(const Structure& structure, Background background)
    : structure_(structure),
      tip_gradients_(gradients_at(structure, structure.rod_tips)),
      kinks_(kink_mesh(rod_radius(structure), palette(background).joints), structure.rod_kinks.size()),
      retractors_(retractor_mesh(rod_radius(structure), palette(background).retractors), structure.rod_tips.size()) {
  props_ = {make_surface(kinks_.mesh(), background), make_surface(retractors_.mesh(), background)};
}

void JointActor::update(const Snapshot& snapshot) {
  for (std::size_t i = 0; i < structure_.rod_kinks.size(); ++i) {
    kinks_.place(i, Eigen::Matrix3d::Identity(), snapshot.positions.col(structure_.rod_kinks[i]));
  }
  kinks_.modified();
  for (std::size_t i = 0; i < structure_.rod_tips.size(); ++i) {
    const Eigen::Vector3d along =
        tip_gradients_[i] >= 0 ? Eigen::Vector3d(snapshot.gradients.col(tip_gradients_[i])) : Eigen::Vector3d::UnitY();
    const Eigen::Vector3d axis = along.normalized();
    const auto cross = cross_axes(axis);
    Eigen::Matrix3d axes;
    axes << cross.first, cross.second, axis;
    retractors_.place(i, axes, snapshot.positions.col(structure_.rod_tips[i]));
  }
  retractors_.modified();
}

}  // namespace netpocket
