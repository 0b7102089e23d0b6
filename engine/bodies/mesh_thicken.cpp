#include "engine/bodies/mesh_thicken.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/bodies/mesh_edges.h"
#include "engine/math/elementary.h"

namespace netpocket {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// The smallest shift d of a corner that moves each of its faces by 1 along its normal n, in the sense of least squares:
// it minimises sum(w (n . d - 1)^2).
Vector3d unit_shift(const Matrix3d& normals_squared, const Vector3d& normal_sum) {
  const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(normals_squared);
  constexpr double kRoundOff = 1e-6;
  const double least = kRoundOff * solver.eigenvalues()[2];
  Vector3d shift = Vector3d::Zero();
  for (int i = 0; i < 3; ++i) {
    if (solver.eigenvalues()[i] <= least) continue;
    const Vector3d axis = solver.eigenvectors().col(i);
    shift += axis.dot(normal_sum) / solver.eigenvalues()[i] * axis;
  }
  // At a sharp tip no moderate shift suits all faces, so it is bounded.
  constexpr double kLongest = 3;
  return shift.norm() > kLongest ? Vector3d(kLongest * shift.normalized()) : shift;
}

double corner_angle(const MeshData& mesh, const Triangle& t, int corner) {
  const Vector3d& at = mesh.vertices[t[corner]];
  const Vector3d u = mesh.vertices[t[(corner + 1) % 3]] - at, v = mesh.vertices[t[(corner + 2) % 3]] - at;
  return arc_tangent(u.cross(v).norm(), u.dot(v));
}

// unit_shift by vertex.
std::vector<Vector3d> unit_shifts(const MeshData& mesh) {
  std::vector<Matrix3d> squared(mesh.vertices.size(), Matrix3d::Zero());
  std::vector<Vector3d> sum(mesh.vertices.size(), Vector3d::Zero());
  for (const Triangle& t : mesh.triangles) {
    const Vector3d normal = area_vector(mesh, t).normalized();
    for (int i = 0; i < 3; ++i) {
      const double weight = corner_angle(mesh, t, i);
      squared[t[i]] += weight * normal * normal.transpose();
      sum[t[i]] += weight * normal;
    }
  }
  std::vector<Vector3d> shifts(mesh.vertices.size());
  for (std::size_t i = 0; i < shifts.size(); ++i) shifts[i] = unit_shift(squared[i], sum[i]);
  return shifts;
}

}  // namespace

std::size_t thicken_open_parts(MeshData& mesh, double thickness) {
  const MeshEdges edges = find_edges(mesh);
  split_vertices(mesh, edges);
  const std::vector<std::int32_t> part_of = part_numbers(edges);
  std::vector<bool> is_open(mesh.triangles.size());  // by part
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const std::int32_t neighbour : edges.neighbours[t]) is_open[part_of[t]] = is_open[part_of[t]] || neighbour < 0;
  }
  const std::vector<Vector3d> shifts = unit_shifts(mesh);
  std::vector<std::int32_t> behind(mesh.vertices.size(), -1);  // by vertex: its twin on the other side
  const std::size_t count = mesh.triangles.size();
  const auto twin = [&](std::int32_t vertex) {
    if (behind[vertex] < 0) {
      behind[vertex] = static_cast<std::int32_t>(mesh.vertices.size());
      const Vector3d middle = mesh.vertices[vertex], shift = thickness / 2 * shifts[vertex];
      mesh.vertices[vertex] = middle + shift;
      mesh.vertices.push_back(middle - shift);
    }
    return behind[vertex];
  };
  for (std::size_t i = 0; i < count; ++i) {
    if (!is_open[part_of[i]]) continue;
    const Triangle front = mesh.triangles[i];
    mesh.triangles.push_back({twin(front[0]), twin(front[2]), twin(front[1])});
    for (int edge = 0; edge < 3; ++edge) {
      if (edges.neighbours[i][edge] >= 0) continue;
      const std::int32_t a = front[edge], b = front[(edge + 1) % 3];
      mesh.triangles.push_back({b, a, twin(a)});
      mesh.triangles.push_back({b, twin(a), twin(b)});
    }
  }
  return static_cast<std::size_t>(std::count(is_open.begin(), is_open.end(), true));
}

}  // namespace netpocket
