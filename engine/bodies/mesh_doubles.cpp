#include "engine/bodies/mesh_doubles.h"

#include <algorithm>
#include <utility>

namespace netpocket {
namespace {

using Entry = std::pair<Triangle, std::int32_t>;

Triangle from_lowest(Triangle corners) {
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  return corners;
}

std::vector<Entry> sorted_triangles(const MeshData& mesh) {
  std::vector<Entry> sorted;
  sorted.reserve(mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    sorted.emplace_back(from_lowest(mesh.triangles[t]), static_cast<std::int32_t>(t));
  }
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

}  // namespace

std::vector<std::int32_t> find_doubles(const MeshData& mesh) {
  const std::vector<Entry> sorted = sorted_triangles(mesh);
  std::vector<std::int32_t> doubles;
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    if (sorted[i].first == sorted[i - 1].first) doubles.push_back(sorted[i].second);
  }
  std::sort(doubles.begin(), doubles.end());
  return doubles;
}

std::vector<std::int32_t> find_backs(const MeshData& mesh) {
  const std::vector<Entry> sorted = sorted_triangles(mesh);
  std::vector<std::int32_t> backs(mesh.triangles.size(), -1);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto [a, b, c] = from_lowest(mesh.triangles[t]);
    const Entry wanted{{a, c, b}, -1};
    const auto found = std::lower_bound(sorted.begin(), sorted.end(), wanted);
    if (found != sorted.end() && found->first == wanted.first) backs[t] = found->second;
  }
  return backs;
}

void drop_triangles(MeshData& mesh, const std::vector<bool>& dropped) {
  std::size_t kept = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (!dropped[t]) mesh.triangles[kept++] = mesh.triangles[t];
  }
  mesh.triangles.resize(kept);
}

}  // namespace netpocket
