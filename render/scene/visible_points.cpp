#include "render/scene/visible_points.h"

#include <Eigen/Geometry>

#include "render/scene/body_mesh.h"

namespace netpocket {
namespace {

// Half the edges of the box around a body, m, body axes.
Eigen::Vector3d half_extent(const StructureBody& body) {
  if (body.role == BodyRole::spacecraft) return spacecraft_half_extent(body.shape);
  return shape_size(body.shape) / 2;
}

// Places on a body's outline: the corners of its box, or for a sphere points on it in the same directions and along the
// axes.
Eigen::Matrix<double, 3, 14> outline(const StructureBody& body) {
  const bool round = std::holds_alternative<Sphere>(body.shape);
  Eigen::Matrix<double, 3, 14> directions;
  for (int i = 0; i < 8; ++i) {
    directions.col(i) = Eigen::Vector3d(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
    if (round) directions.col(i).normalize();
  }
  directions.middleCols<3>(8).setIdentity();
  directions.rightCols<3>() = -directions.middleCols<3>(8);
  return half_extent(body).asDiagonal() * directions;
}

}  // namespace

Eigen::Matrix3Xd visible_points(const Structure& structure, const Snapshot& snapshot) {
  const auto nodes = snapshot.positions.cols();
  Eigen::Matrix3Xd points(3, nodes + 14 * static_cast<Eigen::Index>(structure.bodies.size()));
  points.leftCols(nodes) = snapshot.positions;
  for (std::size_t i = 0; i < structure.bodies.size(); ++i) {
    const auto& state = snapshot.bodies[i];
    points.middleCols<14>(nodes + 14 * static_cast<Eigen::Index>(i)) =
        (state.attitude.toRotationMatrix() * outline(structure.bodies[i])).colwise() + state.position;
  }
  return points;
}

}  // namespace netpocket
