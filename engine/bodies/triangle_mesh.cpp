#include "engine/bodies/triangle_mesh.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <utility>

#include "engine/bodies/mesh_review.h"
#include "engine/bodies/mesh_weld.h"
#include "engine/math/elementary.h"

namespace netpocket {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// Sums of volume, first and second moments of the tetrahedra between the origin and the triangles.
struct Moments {
  double volume = 0;
  Vector3d first = Vector3d::Zero();
  Matrix3d second = Matrix3d::Zero();  // integral of x x^T
};

Moments integrate_solid(const MeshData& data) {
  Moments sum;
  for (const Triangle& triangle : data.triangles) {
    const Vector3d &a = data.vertices[triangle[0]], &b = data.vertices[triangle[1]], &c = data.vertices[triangle[2]];
    const double determinant = a.dot(b.cross(c));
    const Vector3d s = a + b + c;
    sum.volume += determinant / 6;
    sum.first += determinant / 24 * s;
    sum.second += determinant / 120 * (s * s.transpose() + a * a.transpose() + b * b.transpose() + c * c.transpose());
  }
  return sum;
}

Vector3d centre_of_mass(const MeshData& data) {
  const Moments moments = integrate_solid(data);
  return moments.first / moments.volume;
}

Vector3d unit_or_zero(const Vector3d& v) {
  const double length = v.norm();
  return length > 0 ? Vector3d(v / length) : Vector3d::Zero();
}

double corner_angle(const Vector3d& at, const Vector3d& b, const Vector3d& c) {
  const Vector3d u = b - at, v = c - at;
  return arc_tangent(u.cross(v).norm(), u.dot(v));
}

}  // namespace

TriangleMesh::Result TriangleMesh::make(const MeshData& data) {
  MeshReview review = review_mesh(data);
  if (!review.faults.empty()) return review.faults.front().text;
  std::shared_ptr<TriangleMesh> mesh(new TriangleMesh(std::move(review.mesh), review.edges));
  mesh->joined_corners_ = review.joined;
  mesh->weld_tolerance_ = review.weld_tolerance;
  return std::shared_ptr<const TriangleMesh>(std::move(mesh));
}

TriangleMesh::Result TriangleMesh::restore(MeshData data) {
  if (std::string problem = number_fault(data); !problem.empty()) return problem;
  if (data.triangles.empty() || data.triangles.size() > kLargestTriangleCount) {
    return fmt::format("has {} triangles, not 1 to {}", data.triangles.size(), kLargestTriangleCount);
  }
  constexpr double kSlack = 1 + 1e-9;  // for round-off of the extent from moving the mesh
  const double extent = mesh_extent(data);
  if (!(extent <= kSlack * kLargestMeshExtent && extent >= kSmallestMeshExtent / kSlack)) {
    return fmt::format("is {:.4g} m large, not {:g} m to {:g} m", extent, kSmallestMeshExtent, kLargestMeshExtent);
  }
  const MeshEdges edges = find_edges(data);
  if (!edges.open.empty() || !edges.forked.empty() || !edges.turned.empty()) {
    return std::string("is not watertight");
  }
  split_vertices(data, edges);
  std::shared_ptr<TriangleMesh> mesh(new TriangleMesh(std::move(data), edges));
  if (!(mesh->volume_ > 0) || !std::isfinite(mesh->volume_)) return std::string("encloses no volume");
  return std::shared_ptr<const TriangleMesh>(std::move(mesh));
}

std::shared_ptr<const TriangleMesh> TriangleMesh::of_closed(MeshData data) {
  const MeshEdges edges = find_edges(data);
  return std::shared_ptr<const TriangleMesh>(new TriangleMesh(std::move(data), edges));
}

TriangleMesh::TriangleMesh(MeshData data, const MeshEdges& edges) : data_(std::move(data)) {
  for (const Vector3d& vertex : data_.vertices) bounds_.extend(vertex);
  integrate();
  find_normals(edges);
  std::vector<TriangleTree::Corners> corners;
  corners.reserve(data_.triangles.size());
  for (const Triangle& t : data_.triangles) {
    corners.push_back({data_.vertices[t[0]], data_.vertices[t[1]], data_.vertices[t[2]]});
  }
  tree_ = TriangleTree(corners);
}

// A mesh that was centred before it was stored is not moved again. All other results follow from the centred vertices.
// So a run that continues with the mesh of its recording gives the same bits.
void TriangleMesh::integrate() {
  constexpr double kRoundOff = 1e-12;  // fraction of the extent; a centred mesh is off by about 1e-15
  const Vector3d offset = centre_of_mass(data_);
  if (!(offset.norm() <= kRoundOff * bounds_.sizes().maxCoeff())) {
    // First moves the middle of the mesh to the origin, so that coordinates far from it lose no digits.
    const Vector3d middle = bounds_.center();
    for (Vector3d& vertex : data_.vertices) vertex -= middle;
    const Vector3d centre = centre_of_mass(data_);
    for (Vector3d& vertex : data_.vertices) vertex -= centre;
    centre_ = middle + centre;
  }
  bounds_.setEmpty();
  for (const Vector3d& vertex : data_.vertices) {
    bounds_.extend(vertex);
    bounding_radius_ = std::max(bounding_radius_, vertex.norm());
  }
  const Moments moments = integrate_solid(data_);
  volume_ = moments.volume;
  const Matrix3d second = moments.second / volume_;
  unit_inertia_ = second.trace() * Matrix3d::Identity() - second;
}

void TriangleMesh::find_normals(const MeshEdges& edges) {
  const auto corner = [&](const Triangle& t, int i) -> const Vector3d& { return data_.vertices[t[i % 3]]; };
  vertex_normals_.assign(data_.vertices.size(), Vector3d::Zero());
  double area = 0;
  for (const Triangle& t : data_.triangles) {
    const Vector3d cross = (corner(t, 1) - corner(t, 0)).cross(corner(t, 2) - corner(t, 0));
    area += cross.norm() / 2;
    face_normals_.push_back(unit_or_zero(cross));
    for (int i = 0; i < 3; ++i) {
      vertex_normals_[t[i]] += corner_angle(corner(t, i), corner(t, i + 1), corner(t, i + 2)) * face_normals_.back();
    }
  }
  for (Vector3d& normal : vertex_normals_) normal = unit_or_zero(normal);
  typical_edge_ = std::sqrt(area / static_cast<double>(data_.triangles.size()) * 4 / std::sqrt(3.0));

  edge_normals_.resize(data_.triangles.size());
  for (std::size_t t = 0; t < data_.triangles.size(); ++t) {
    for (int edge = 0; edge < 3; ++edge) {
      const std::int32_t neighbour = edges.neighbours[t][edge];
      edge_normals_[t][edge] = unit_or_zero(face_normals_[t] + face_normals_[neighbour / 3]);
    }
  }
}

Vector3d TriangleMesh::pseudo_normal(const TriangleHit& hit) const {
  const std::int32_t triangle = tree_.index(hit.place);
  switch (hit.feature) {
    case TriangleFeature::corner0:
    case TriangleFeature::corner1:
    case TriangleFeature::corner2:
      return vertex_normals_[data_.triangles[triangle][static_cast<int>(hit.feature)]];
    case TriangleFeature::edge01:
    case TriangleFeature::edge12:
    case TriangleFeature::edge20:
      return edge_normals_[triangle][static_cast<int>(hit.feature) - static_cast<int>(TriangleFeature::edge01)];
    case TriangleFeature::face:
      break;
  }
  return face_normals_[triangle];
}

SurfacePoint TriangleMesh::surface_point(const Vector3d& point, const TriangleHit& hit) const {
  // A point that is not finite has no nearest triangle.
  if (hit.place < 0) return {std::numeric_limits<double>::quiet_NaN(), Vector3d::UnitY()};
  const Vector3d pseudo = pseudo_normal(hit);
  const Vector3d arm = point - hit.point;
  const double distance = std::sqrt(hit.squared_distance);
  const double side = arm.dot(pseudo) < 0 ? -1.0 : 1.0;
  // The normal of a face is more accurate than the arm. Very near the surface the arm has lost its direction.
  constexpr double kOnSurface = 1e-9;
  const bool keep_pseudo = hit.feature == TriangleFeature::face || distance < kOnSurface * bounding_radius_;
  return {side * distance, keep_pseudo ? pseudo : Vector3d(side / distance * arm)};
}

SurfacePoint TriangleMesh::nearest(const Vector3d& point) const { return surface_point(point, tree_.nearest(point)); }

SurfacePoint TriangleMesh::nearest_among(const Vector3d& point, std::span<const std::int32_t> places) const {
  return surface_point(point, tree_.nearest_among(point, places));
}

bool TriangleMesh::is_nearer(const Vector3d& point, double reach) const {
  if (!point.allFinite() || tree_.any_within(point, reach)) return true;
  return bounds_.contains(point) && nearest(point).distance < 0;
}

}  // namespace netpocket
