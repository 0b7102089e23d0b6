#include "engine/bodies/mesh_edges.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <span>
#include <tuple>

#include "engine/math/elementary.h"

namespace netpocket {
namespace {

using Eigen::Vector3d;

// A side with its vertices in ascending order, from < to. `forward`: whether the triangle runs from `from` to `to`.
struct Side {
  std::int32_t from, to;
  bool forward;
  TriangleSide side;

  std::int32_t number() const { return 3 * side.triangle + side.edge; }
};

std::vector<Side> sorted_sides(const std::vector<Triangle>& triangles) {
  std::vector<Side> sides;
  sides.reserve(3 * triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (int edge = 0; edge < 3; ++edge) {
      const std::int32_t a = triangles[t][edge], b = triangles[t][(edge + 1) % 3];
      sides.push_back({std::min(a, b), std::max(a, b), a < b, {static_cast<std::int32_t>(t), edge}});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return std::tie(a.from, a.to, a.side.triangle, a.side.edge) < std::tie(b.from, b.to, b.side.triangle, b.side.edge);
  });
  return sides;
}

void join(MeshEdges& edges, const Side& a, const Side& b) {
  edges.neighbours[a.side.triangle][a.side.edge] = b.number();
  edges.neighbours[b.side.triangle][b.side.edge] = a.number();
}

constexpr double kSameAngle = 1e-7;  // rad

// Angle (rad, in [0, 2 pi)) of each side's triangle about the edge, measured from the first triangle.
std::vector<double> angles_about(const MeshData& mesh, std::span<const Side> sides) {
  const Vector3d& from = mesh.vertices[sides[0].from];
  const Vector3d axis = (mesh.vertices[sides[0].to] - from).normalized();
  const auto across = [&](const Side& s) {
    const Vector3d arm = mesh.vertices[mesh.triangles[s.side.triangle][(s.side.edge + 2) % 3]] - from;
    return Vector3d(arm - arm.dot(axis) * axis);
  };
  const Vector3d x = across(sides[0]).normalized(), y = axis.cross(x);
  constexpr double kTurn = 2 * std::numbers::pi;
  std::vector<double> angles;
  for (const Side& s : sides) {
    const Vector3d arm = across(s);
    const double angle = arc_tangent(arm.dot(y), arm.dot(x));
    angles.push_back(angle < -kSameAngle ? angle + kTurn : std::max(angle, 0.0));
  }
  return angles;
}

// Joins the sides of one edge in pairs that bound a wedge of the solid. In the order of angles, the solid begins behind
// a triangle that runs against the edge and ends at the next triangle that runs along it. There must be equally many of
// both kinds.
void join_wedges(const MeshData& mesh, std::span<const Side> sides, MeshEdges& edges) {
  const std::vector<double> angles = angles_about(mesh, sides);
  std::vector<std::size_t> order(sides.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return angles[a] < angles[b]; });
  // Among coinciding triangles, those that end a wedge come first, because touching parts enclose nothing between them.
  for (std::size_t first = 0, next = 0; first < order.size(); first = next) {
    while (next < order.size() && angles[order[next]] - angles[order[first]] <= kSameAngle) ++next;
    std::stable_partition(order.begin() + static_cast<std::ptrdiff_t>(first),
                          order.begin() + static_cast<std::ptrdiff_t>(next),
                          [&](std::size_t i) { return sides[i].forward; });
  }
  // Beginnings and ends match like brackets on a circle, so that two rounds are needed.
  std::vector<std::size_t> begun;
  for (std::size_t i = 0; i < 2 * order.size(); ++i) {
    const std::size_t at = order[i % order.size()];
    const bool second_round = i >= order.size();
    if (!sides[at].forward) {
      if (!second_round) begun.push_back(at);
    } else if (!begun.empty() && edges.neighbours[sides[at].side.triangle][sides[at].side.edge] < 0) {
      join(edges, sides[begun.back()], sides[at]);
      begun.pop_back();
    }
  }
}

// Union-find: disjoint sets of numbers. The first (smallest) number represents a set.
class Groups {
 public:
  explicit Groups(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }
  std::int32_t first(std::int32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void unite(std::int32_t a, std::int32_t b) {
    a = first(a);
    b = first(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::int32_t> parent_;
};

}  // namespace

MeshEdges find_edges(const MeshData& mesh) {
  MeshEdges edges;
  edges.neighbours.assign(mesh.triangles.size(), {-1, -1, -1});
  const std::vector<Side> sides = sorted_sides(mesh.triangles);
  for (std::size_t first = 0, next = 0; first < sides.size(); first = next) {
    while (next < sides.size() && sides[next].from == sides[first].from && sides[next].to == sides[first].to) ++next;
    const std::span<const Side> here(&sides[first], next - first);
    const auto forward = std::count_if(here.begin(), here.end(), [](const Side& s) { return s.forward; });
    if (here.size() == 1) {
      edges.open.push_back(here[0].side);
    } else if (here.size() == 2) {
      join(edges, here[0], here[1]);
      if (forward != 1) edges.turned.push_back(here[0].side);
    } else if (2 * static_cast<std::size_t>(forward) != here.size()) {
      edges.forked.push_back(here[0].side);
    } else {
      join_wedges(mesh, here, edges);
    }
  }
  return edges;
}

Vector3d middle(const MeshData& mesh, const TriangleSide& side) {
  const Triangle& t = mesh.triangles[side.triangle];
  return (mesh.vertices[t[side.edge]] + mesh.vertices[t[(side.edge + 1) % 3]]) / 2;
}

std::vector<std::int32_t> part_numbers(const MeshEdges& edges) {
  Groups groups(edges.neighbours.size());
  for (std::size_t t = 0; t < edges.neighbours.size(); ++t) {
    for (const std::int32_t neighbour : edges.neighbours[t]) {
      if (neighbour >= 0) groups.unite(static_cast<std::int32_t>(t), neighbour / 3);
    }
  }
  std::vector<std::int32_t> numbers(edges.neighbours.size(), -1);
  std::int32_t count = 0;
  for (std::size_t t = 0; t < numbers.size(); ++t) {
    const std::int32_t first = groups.first(static_cast<std::int32_t>(t));
    numbers[t] = first == static_cast<std::int32_t>(t) ? count++ : numbers[first];
  }
  return numbers;
}

void split_vertices(MeshData& mesh, const MeshEdges& edges) {
  // Corners are numbered 3 * triangle + place. Corners at the same end of joined sides belong to one set.
  Groups corners(3 * mesh.triangles.size());
  const auto vertex = [&](std::int32_t corner) -> std::int32_t& { return mesh.triangles[corner / 3][corner % 3]; };
  const auto next = [](std::int32_t corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; };
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (int edge = 0; edge < 3; ++edge) {
      const std::int32_t here = static_cast<std::int32_t>(3 * t) + edge, neighbour = edges.neighbours[t][edge];
      if (neighbour < here) continue;
      const bool opposite = vertex(here) == vertex(next(neighbour));
      corners.unite(here, opposite ? next(neighbour) : neighbour);
      corners.unite(next(here), opposite ? neighbour : next(neighbour));
    }
  }
  // The first set of corners at a vertex keeps it; each other set gets a copy.
  std::vector<std::int32_t> owner(mesh.vertices.size(), -1);
  std::vector<std::int32_t> copies(3 * mesh.triangles.size(), -1);  // by the set's first corner
  for (std::int32_t corner = 0; corner < static_cast<std::int32_t>(3 * mesh.triangles.size()); ++corner) {
    const std::int32_t set = corners.first(corner);
    std::int32_t& number = vertex(corner);
    if (owner[number] < 0) owner[number] = set;
    if (owner[number] == set) continue;
    if (copies[set] < 0) {
      copies[set] = static_cast<std::int32_t>(mesh.vertices.size());
      const Vector3d copy = mesh.vertices[number];
      mesh.vertices.push_back(copy);
    }
    number = copies[set];
  }
}

}  // namespace netpocket
