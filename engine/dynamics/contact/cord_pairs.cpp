#include "engine/dynamics/contact/cord_pairs.h"

#include <algorithm>
#include <limits>
#include <map>

#include "engine/contact/near_pairs.h"

namespace netpocket {
namespace {

using Eigen::AlignedBox3d;
using Eigen::Vector3d;

// Elements are neighbours if the cord between them is shorter than this many diameters of either.
constexpr double kNeighbourhood = 2;

// Indices of the elements at each node.
std::vector<std::vector<std::int32_t>> elements_by_node(const Model& model) {
  std::vector<std::vector<std::int32_t>> result(model.nodes.size());
  for (std::size_t i = 0; i < model.elements.size(); ++i) {
    result[static_cast<std::size_t>(model.elements[i].node1)].push_back(static_cast<std::int32_t>(i));
    result[static_cast<std::size_t>(model.elements[i].node2)].push_back(static_cast<std::int32_t>(i));
  }
  return result;
}

// The elements within `reach` (m) of the ends of `start`, measured along the cords. Sorted.
std::vector<std::int32_t> neighbours(const Model& model, const std::vector<std::vector<std::int32_t>>& at_node,
                                     const ModelElement& start, double reach) {
  std::vector<std::int32_t> found;
  std::map<std::int32_t, double> left = {{start.node1, reach}, {start.node2, reach}};  // m, by node
  std::vector<std::int32_t> open = {start.node1, start.node2};
  while (!open.empty()) {
    const std::int32_t node = open.back();
    open.pop_back();
    for (const std::int32_t index : at_node[static_cast<std::size_t>(node)]) {
      const ModelElement& element = model.elements[static_cast<std::size_t>(index)];
      found.push_back(index);
      const double beyond = left[node] - element.length;
      const std::int32_t next = element.node1 == node ? element.node2 : element.node1;
      if (beyond <= left[next]) continue;  // left is 0 at nodes not reached yet
      left[next] = beyond;
      open.push_back(next);
    }
  }
  std::ranges::sort(found);
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

bool share_node(const ModelElement& a, const ModelElement& b) {
  return a.node1 == b.node1 || a.node1 == b.node2 || a.node2 == b.node1 || a.node2 == b.node2;
}

double distance(const CordPolyline::Vertices& a, const CordPolyline::Vertices& b) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < a.size(); ++i) {
    for (std::size_t j = 0; j + 1 < b.size(); ++j) {
      least = std::min(least, closest_points({a[i], a[i + 1]}, {b[j], b[j + 1]}).distance);
    }
  }
  return least;
}

}  // namespace

CordPairs::CordPairs(const Model& model, const CordPolyline& polyline, const CoordinateVectors& coordinates,
                     std::span<const double> inverse_mass)
    : model_(model) {
  const auto at_node = elements_by_node(model);
  std::vector<CordPolyline::Vertices> vertices;
  std::vector<AlignedBox3d> boxes;
  std::vector<double> radius;
  for (std::size_t i = 0; i < model.elements.size(); ++i) {
    const ModelElement& element = model.elements[i];
    const auto index = static_cast<std::int32_t>(i);
    radius.push_back(model.material_of(index).radius);
    for (const std::int32_t other : neighbours(model, at_node, element, 2 * kNeighbourhood * radius.back())) {
      if (!share_node(element, model.elements[static_cast<std::size_t>(other)])) neighbours_.push_back(other);
    }
    first_neighbour_.push_back(static_cast<std::int32_t>(neighbours_.size()));
    solid_.push_back(radius.back() > 0);
    const auto& indices = polyline.indices(index);
    moves_.push_back(
        std::ranges::any_of(indices, [&](std::int32_t coordinate) { return inverse_mass[coordinate] > 0; }));
    vertices.push_back(polyline.vertices(coordinates, element.length, index));
    AlignedBox3d box;
    for (const Vector3d& vertex : vertices.back()) box.extend(vertex);
    boxes.emplace_back(box.min().array() - radius.back(), box.max().array() + radius.back());
  }
  if (boxes.empty()) return;
  for (const auto& [first, second] : near_pairs(boxes, 1e-6)) {
    const auto a = static_cast<std::size_t>(first), b = static_cast<std::size_t>(second);
    if (!may_touch(first, second)) continue;
    if (distance(vertices[a], vertices[b]) >= radius[a] + radius[b]) continue;
    const ThreadPair threads = std::minmax(model_.elements[a].thread, model_.elements[b].thread);
    joined_threads_.insert(std::ranges::upper_bound(joined_threads_, threads), threads);
  }
}

bool CordPairs::may_touch(std::int32_t first, std::int32_t second) const {
  const auto a = static_cast<std::size_t>(first), b = static_cast<std::size_t>(second);
  if (!solid_[a] || !solid_[b] || !(moves_[a] || moves_[b])) return false;
  const auto are_neighbours = [&](std::size_t element, std::int32_t other) {
    return std::binary_search(neighbours_.begin() + first_neighbour_[element],
                              neighbours_.begin() + first_neighbour_[element + 1], other);
  };
  if (share_node(model_.elements[a], model_.elements[b])) return false;
  if (are_neighbours(a, second) || are_neighbours(b, first)) {
    return false;
  }
  const ThreadPair threads = std::minmax(model_.elements[a].thread, model_.elements[b].thread);
  return !std::ranges::binary_search(joined_threads_, threads);
}

}  // namespace netpocket
