#include "render/scene/body_actor.h"

#include <vtkMatrix4x4.h>
#include <vtkProperty.h>

#include <algorithm>

#include "render/scene/body_mesh.h"
#include "render/scene/surface_props.h"

namespace netpocket {
namespace {

constexpr double kLineWidth = 0.8;      // pixels of a picture 720 pixels high
constexpr double kSmallestWidth = 0.5;  // pixels

struct RootCircle {
  double radius;  // m, about the body's y axis
  double height;  // m, along it, from the centre of mass
};

// The circle on which the rods are clamped to the spacecraft.
RootCircle root_circle(const Structure& structure, const Snapshot& snapshot, const BodyState& spacecraft) {
  RootCircle circle{0, 0};
  const std::vector<std::int32_t> nodes = structure.nodes(NodeLook::adapter);
  for (const auto node : nodes) {
    const Eigen::Vector3d arm = snapshot.positions.col(node) - spacecraft.position;
    const Eigen::Vector3d in_body = spacecraft.attitude.conjugate() * arm;
    circle.radius += std::hypot(in_body.x(), in_body.z()) / static_cast<double>(nodes.size());
    circle.height += in_body.y() / static_cast<double>(nodes.size());
  }
  return circle;
}

BodyMesh body_mesh(const Structure& structure, std::size_t body, const Snapshot& snapshot, const Palette& palette) {
  const auto& shape = structure.bodies[body].shape;
  if (structure.bodies[body].role != BodyRole::spacecraft) return shape_mesh(shape, palette);
  const auto circle = root_circle(structure, snapshot, snapshot.bodies[body]);
  return spacecraft_mesh(shape, circle.radius, circle.height);
}

}  // namespace

BodyActor::BodyActor(const Structure& structure, std::size_t body, const SceneOptions& options)
    : structure_(structure), body_(body), options_(options), lines_(make_lines(line_mesh_)) {
  auto surface = make_surface(surface_mesh_, options.background);
  surface->SetUserTransform(pose_);
  if (structure.bodies[body].role == BodyRole::target) surface->GetProperty()->SetOpacity(options.target_opacity);
  lines_->SetUserTransform(pose_);
  props_ = {surface, lines_};
}

void BodyActor::update(const Snapshot& snapshot) {
  if (surface_mesh_->GetNumberOfPoints() == 0) {
    const auto mesh = body_mesh(structure_, body_, snapshot, palette(options_.background));
    surface_mesh_->ShallowCopy(mesh.surface);
    line_mesh_->ShallowCopy(mesh.lines);
  }
  const auto& state = snapshot.bodies[body_];
  Eigen::Matrix<double, 4, 4, Eigen::RowMajor> matrix = Eigen::Matrix4d::Identity();
  matrix.topLeftCorner<3, 3>() = state.attitude.toRotationMatrix();
  matrix.topRightCorner<3, 1>() = state.position;
  pose_->SetMatrix(matrix.data());
}

void BodyActor::adapt(const View& view) {
  const double width = std::max(kLineWidth * options_.line_scale * view.scale(), kSmallestWidth);
  lines_->GetProperty()->SetLineWidth(static_cast<float>(width));
}

}  // namespace netpocket
