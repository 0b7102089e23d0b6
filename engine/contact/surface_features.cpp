#include "engine/contact/surface_features.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "engine/math/elementary.h"

namespace netpocket {
namespace {

using Eigen::Vector3d;

// Two faces have no edge between them if the sine of the angle between their normals is below this.
constexpr double kFlat = 0.02;

struct Loop {
  Vector3d normal;
  std::span<const std::int32_t> corners;
};

// Convex edges between faces. `corners` has all vertices.
std::vector<FeatureEdge> convex_edges(const std::vector<FeatureCorner>& corners, const std::vector<Loop>& faces) {
  std::map<std::pair<std::int32_t, std::int32_t>, Vector3d> first_normal;
  std::vector<FeatureEdge> edges;
  for (const Loop& face : faces) {
    for (std::size_t i = 0; i < face.corners.size(); ++i) {
      const std::int32_t a = face.corners[i], b = face.corners[(i + 1) % face.corners.size()];
      const auto [other, is_new] =
          first_normal.try_emplace(std::pair<std::int32_t, std::int32_t>(std::minmax(a, b)), face.normal);
      if (is_new) continue;
      const FeatureCorner &begin = corners[static_cast<std::size_t>(a)], &end = corners[static_cast<std::size_t>(b)];
      // Seen from outside, this face is to the left of the direction from a to b, the other face to its right.
      const Vector3d along = (end.point - begin.point).normalized();
      if (symmetric_dot(along, face.normal.cross(other->second)) < kFlat) continue;
      edges.push_back({begin.point, end.point, along.cross(face.normal), other->second.cross(along),
                       std::min(begin.weight, end.weight)});
    }
  }
  return edges;
}

double angle_between(const Vector3d& a, const Vector3d& b) { return arc_tangent(a.cross(b).norm(), a.dot(b)); }

// Area by vertex: the area of each triangle is divided among its corners in proportion to their angles.
std::vector<double> corner_areas(const TriangleMesh& mesh) {
  std::vector<double> areas(mesh.vertices().size(), 0.0);
  for (const Triangle& triangle : mesh.triangles()) {
    std::array<Vector3d, 3> p;
    for (std::size_t i = 0; i < 3; ++i) p[i] = mesh.vertices()[static_cast<std::size_t>(triangle[i])];
    const double area = 0.5 * (p[1] - p[0]).cross(p[2] - p[0]).norm();
    for (std::size_t i = 0; i < 3; ++i) {
      const double angle = angle_between(p[(i + 1) % 3] - p[i], p[(i + 2) % 3] - p[i]);
      areas[static_cast<std::size_t>(triangle[i])] += area * angle / std::numbers::pi;
    }
  }
  return areas;
}

}  // namespace

SurfaceFeatures features_of(const Polytope& polytope) {
  SurfaceFeatures features;
  for (const Vector3d& vertex : polytope.vertices()) features.corners.push_back({vertex, polytope.weight()});
  std::vector<Loop> faces;
  for (const Polytope::Face& face : polytope.faces()) faces.push_back({face.normal, face.corners});
  features.edges = convex_edges(features.corners, faces);
  return features;
}

SurfaceFeatures features_of(const TriangleMesh& mesh) {
  const std::vector<double> areas = corner_areas(mesh);
  double whole = 0;
  for (const double area : areas) whole += area;
  SurfaceFeatures features;
  for (std::size_t i = 0; i < areas.size(); ++i) {
    features.corners.push_back({mesh.vertices()[i], std::min(1.0, 8 * areas[i] / whole)});
  }
  std::vector<Loop> faces;
  for (std::size_t i = 0; i < mesh.triangles().size(); ++i) faces.push_back({mesh.face_normal(i), mesh.triangles()[i]});
  features.edges = convex_edges(features.corners, faces);
  return features;
}

}  // namespace netpocket
