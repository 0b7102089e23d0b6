#include "engine/bodies/triangle_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>

#include "engine/math/elementary.h"

namespace netpocket {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// One side of a triangle; `from < to` after sorting, `forward` says whether the triangle runs that way.
struct Side {
  std::int32_t from, to;
  bool forward;
  std::int32_t triangle;
  int edge;
};

std::vector<Side> sorted_sides(const std::vector<Triangle>& triangles) {
  std::vector<Side> sides;
  sides.reserve(3 * triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (int edge = 0; edge < 3; ++edge) {
      const std::int32_t a = triangles[t][edge], b = triangles[t][(edge + 1) % 3];
      sides.push_back({std::min(a, b), std::max(a, b), a < b, static_cast<std::int32_t>(t), edge});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return std::tie(a.from, a.to, a.triangle, a.edge) < std::tie(b.from, b.to, b.triangle, b.edge);
  });
  return sides;
}

bool same_edge(const Side& a, const Side& b) { return a.from == b.from && a.to == b.to; }

std::string place_text(const Vector3d& p) { return fmt::format("({:.4g}, {:.4g}, {:.4g}) m", p.x(), p.y(), p.z()); }

// What is wrong with the numbers, before anything is computed from them.
std::optional<std::string> number_problem(const MeshData& data) {
  const auto count = static_cast<std::int32_t>(data.vertices.size());
  for (const Triangle& triangle : data.triangles) {
    for (const std::int32_t corner : triangle) {
      if (corner < 0 || corner >= count) return "has a triangle with a corner that does not exist";
    }
  }
  for (const Vector3d& vertex : data.vertices) {
    if (!vertex.allFinite()) return "has a corner whose coordinates are not finite numbers";
  }
  return std::nullopt;
}

std::optional<std::string> size_problem(const MeshData& data) {
  if (data.triangles.empty()) return "has no triangles";
  if (data.triangles.size() > kLargestTriangleCount) {
    return fmt::format("has {} triangles; {} are allowed", data.triangles.size(), kLargestTriangleCount);
  }
  Eigen::AlignedBox3d box;
  for (const Triangle& triangle : data.triangles) {
    for (const std::int32_t corner : triangle) box.extend(data.vertices[corner]);
  }
  const double extent = box.sizes().maxCoeff();
  if (!(extent <= kLargestMeshExtent && extent >= kSmallestMeshExtent)) {
    return fmt::format("is {:.4g} m large, not {:g} m to {:g} m as is allowed: is its unit right?", extent,
                       kSmallestMeshExtent, kLargestMeshExtent);
  }
  return std::nullopt;
}

// Each edge must join exactly two triangles, which run along it in opposite directions.
std::optional<std::string> surface_problem(const MeshData& data) {
  const std::vector<Side> sides = sorted_sides(data.triangles);
  std::size_t open = 0, turned = 0;
  Vector3d open_place = Vector3d::Zero(), turned_place = Vector3d::Zero();
  for (std::size_t first = 0, next = 0; first < sides.size(); first = next) {
    while (next < sides.size() && same_edge(sides[first], sides[next])) ++next;
    const Vector3d middle = (data.vertices[sides[first].from] + data.vertices[sides[first].to]) / 2;
    if (next - first != 2) {
      if (open++ == 0) open_place = middle;
    } else if (sides[first].forward == sides[first + 1].forward) {
      if (turned++ == 0) turned_place = middle;
    }
  }
  if (open > 0) {
    return fmt::format("is not watertight: {} of its edges {} not join exactly two triangles, one of them at {}", open,
                       open == 1 ? "does" : "do", place_text(open_place));
  }
  if (turned > 0) {
    return fmt::format("has neighbouring triangles that face opposite ways, at {} edges, one of them at {}", turned,
                       place_text(turned_place));
  }
  return std::nullopt;
}

// Volume, first and second moments of the tetrahedra between the origin and the triangles.
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

Vector3d unit_or_zero(const Vector3d& v) {
  const double length = v.norm();
  return length > 0 ? Vector3d(v / length) : Vector3d::Zero();
}

double corner_angle(const Vector3d& at, const Vector3d& b, const Vector3d& c) {
  const Vector3d u = b - at, v = c - at;
  return arc_tangent(u.cross(v).norm(), u.dot(v));
}

}  // namespace

MeshData welded(const MeshData& data) {
  const auto key = [&](std::int32_t i) {  // + 0.0: a zero has one sign
    const Vector3d& v = data.vertices[i];
    return std::array{v.x() + 0.0, v.y() + 0.0, v.z() + 0.0};
  };
  std::vector<std::int32_t> order(data.vertices.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
            [&](std::int32_t a, std::int32_t b) { return std::pair(key(a), a) < std::pair(key(b), b); });
  std::vector<std::int32_t> twin(data.vertices.size());  // the first vertex at the same place
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool repeated = i > 0 && key(order[i]) == key(order[i - 1]);
    twin[order[i]] = repeated ? twin[order[i - 1]] : order[i];
  }
  MeshData result;
  std::vector<std::int32_t> renumbered(data.vertices.size(), -1);
  for (const Triangle& triangle : data.triangles) {
    const Triangle t = {twin[triangle[0]], twin[triangle[1]], twin[triangle[2]]};
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) continue;
    Triangle& added = result.triangles.emplace_back();
    for (int i = 0; i < 3; ++i) {
      std::int32_t& number = renumbered[t[i]];
      if (number < 0) {
        number = static_cast<std::int32_t>(result.vertices.size());
        result.vertices.push_back(data.vertices[t[i]]);
      }
      added[i] = number;
    }
  }
  return result;
}

std::variant<std::shared_ptr<const TriangleMesh>, std::string> TriangleMesh::make(MeshData data) {
  if (auto problem = number_problem(data)) return *problem;
  data = welded(data);
  if (auto problem = size_problem(data)) return *problem;
  if (auto problem = surface_problem(data)) return *problem;
  std::shared_ptr<TriangleMesh> mesh(new TriangleMesh(std::move(data)));
  mesh->integrate();
  const double size = mesh->bounds_.sizes().maxCoeff();
  if (mesh->volume_ < 0)
    return fmt::format("is inverted: its triangles face inwards (volume {:.4g} m^3)", mesh->volume_);
  constexpr double kFlat = 1e-12;
  if (!(mesh->volume_ > kFlat * size * size * size)) return "encloses no volume";
  mesh->find_normals();
  std::vector<TriangleTree::Corners> corners;
  corners.reserve(mesh->triangles().size());
  for (const Triangle& t : mesh->triangles()) {
    corners.push_back({mesh->vertices()[t[0]], mesh->vertices()[t[1]], mesh->vertices()[t[2]]});
  }
  mesh->tree_ = TriangleTree(corners);
  return std::shared_ptr<const TriangleMesh>(std::move(mesh));
}

TriangleMesh::TriangleMesh(MeshData data) : data_(std::move(data)) {
  for (const Vector3d& vertex : data_.vertices) bounds_.extend(vertex);
}

void TriangleMesh::integrate() {
  // About the middle of the mesh, so that far-away coordinates cost no digits.
  const Vector3d middle = bounds_.center();
  for (Vector3d& vertex : data_.vertices) vertex -= middle;
  const Moments moments = integrate_solid(data_);
  volume_ = moments.volume;
  const Vector3d centre = moments.first / volume_;
  for (Vector3d& vertex : data_.vertices) {
    vertex -= centre;
    bounding_radius_ = std::max(bounding_radius_, vertex.norm());
  }
  centre_ = middle + centre;
  bounds_.translate(-centre_);
  const Matrix3d second = moments.second / volume_ - centre * centre.transpose();
  unit_inertia_ = second.trace() * Matrix3d::Identity() - second;
}

void TriangleMesh::find_normals() {
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
  const std::vector<Side> sides = sorted_sides(data_.triangles);
  for (std::size_t i = 0; i < sides.size(); i += 2) {
    const Vector3d sum = face_normals_[sides[i].triangle] + face_normals_[sides[i + 1].triangle];
    for (const Side& side : {sides[i], sides[i + 1]}) edge_normals_[side.triangle][side.edge] = unit_or_zero(sum);
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
  // Of a point that is not finite no triangle is the nearest.
  if (hit.place < 0) return {std::numeric_limits<double>::quiet_NaN(), Vector3d::UnitY()};
  const Vector3d pseudo = pseudo_normal(hit);
  const Vector3d arm = point - hit.point;
  const double distance = std::sqrt(hit.squared_distance);
  const double side = arm.dot(pseudo) < 0 ? -1.0 : 1.0;
  // On a face its normal is the sharpest; on the surface itself the arm has lost its direction.
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
