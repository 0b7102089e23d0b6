#include "engine/bodies/mesh_weld.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <unordered_map>
#include <utility>

namespace netpocket {
namespace {

using Eigen::Vector3d;

std::array<double, 3> coordinates(const Vector3d& v) {
  return {v.x() + 0.0, v.y() + 0.0, v.z() + 0.0};  // + 0.0 turns -0 into +0
}

// By vertex: the first one with the same coordinates.
std::vector<std::int32_t> equal_vertices(const std::vector<Vector3d>& vertices) {
  const auto key = [&](std::int32_t i) { return coordinates(vertices[i]); };
  std::vector<std::int32_t> order(vertices.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
            [&](std::int32_t a, std::int32_t b) { return std::pair(key(a), a) < std::pair(key(b), b); });
  std::vector<std::int32_t> twin(vertices.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool repeated = i > 0 && key(order[i]) == key(order[i - 1]);
    twin[order[i]] = repeated ? twin[order[i - 1]] : order[i];
  }
  return twin;
}

// Hash grid of vertices. The edge of its cubes is four tolerances, so that few cubes are near a point.
class Cubes {
 public:
  Cubes(const std::vector<Vector3d>& vertices, double tolerance) : vertices_(vertices), tolerance_(tolerance) {}

  // The first vertex that was added and is within the tolerance.
  std::optional<std::int32_t> find(const Vector3d& point) const {
    std::optional<std::int32_t> found;
    const Vector3d reach = Vector3d::Constant(1.001 * tolerance_);
    const Cell low = cell(point - reach), high = cell(point + reach);
    for (std::int64_t x = low[0]; x <= high[0]; ++x) {
      for (std::int64_t y = low[1]; y <= high[1]; ++y) {
        for (std::int64_t z = low[2]; z <= high[2]; ++z) {
          const auto [first, last] = cubes_.equal_range(hash({x, y, z}));
          for (auto entry = first; entry != last; ++entry) {
            const std::int32_t vertex = entry->second;
            if ((vertices_[vertex] - point).norm() <= tolerance_ && (!found || vertex < *found)) found = vertex;
          }
        }
      }
    }
    return found;
  }

  void add(std::int32_t vertex) { cubes_.emplace(hash(cell(vertices_[vertex])), vertex); }

 private:
  using Cell = std::array<std::int64_t, 3>;

  Cell cell(const Vector3d& point) const {
    Cell result;
    constexpr double kFarthest = 4e18;  // fits into std::int64_t
    for (int i = 0; i < 3; ++i) {
      result[i] = static_cast<std::int64_t>(std::clamp(std::floor(point[i] / (4 * tolerance_)), -kFarthest, kFarthest));
    }
    return result;
  }
  static std::uint64_t hash(const Cell& cell) {
    std::uint64_t value = 0;
    for (const std::int64_t number : cell) {
      value = (value ^ static_cast<std::uint64_t>(number)) * 0x9e3779b97f4a7c15u;
      value ^= value >> 29;
    }
    return value;
  }

  const std::vector<Vector3d>& vertices_;
  double tolerance_;
  std::unordered_multimap<std::uint64_t, std::int32_t> cubes_;
};

// By vertex: whether a triangle uses it or an equal one.
std::vector<bool> used_vertices(const MeshData& data, const std::vector<std::int32_t>& twin) {
  std::vector<bool> used(data.vertices.size());
  for (const Triangle& t : data.triangles) {
    for (const std::int32_t corner : t) used[corner] = used[twin[corner]] = true;
  }
  return used;
}

}  // namespace

double mesh_extent(const MeshData& data) {
  Eigen::AlignedBox3d box;
  for (const Triangle& t : data.triangles) {
    for (const std::int32_t corner : t) box.extend(data.vertices[corner]);
  }
  return box.isEmpty() ? 0 : box.sizes().maxCoeff();
}

WeldedMesh weld(const MeshData& data, double tolerance) {
  WeldedMesh result{{}, tolerance, 0, 0};
  std::vector<std::int32_t> twin = equal_vertices(data.vertices);
  if (tolerance > 0) {
    const std::vector<bool> used = used_vertices(data, twin);
    Cubes cubes(data.vertices, tolerance);
    for (std::size_t i = 0; i < twin.size(); ++i) {
      if (!used[i]) continue;
      const auto first = static_cast<std::size_t>(twin[i]);
      if (first != i) {
        // The twin comes earlier in the list and has been joined already.
        result.joined += twin[first] != twin[i] ? 1 : 0;
        twin[i] = twin[first];
      } else if (const auto near = cubes.find(data.vertices[i])) {
        ++result.joined;
        twin[i] = *near;
      } else {
        cubes.add(static_cast<std::int32_t>(i));
      }
    }
  }
  std::vector<std::int32_t> renumbered(data.vertices.size(), -1);
  for (const Triangle& triangle : data.triangles) {
    const Triangle t = {twin[triangle[0]], twin[triangle[1]], twin[triangle[2]]};
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) {
      ++result.shrunk;
      continue;
    }
    Triangle& added = result.mesh.triangles.emplace_back();
    for (int i = 0; i < 3; ++i) {
      std::int32_t& number = renumbered[t[i]];
      if (number < 0) {
        number = static_cast<std::int32_t>(result.mesh.vertices.size());
        result.mesh.vertices.push_back(data.vertices[t[i]]);
      }
      added[i] = number;
    }
  }
  return result;
}

}  // namespace netpocket
