#include "engine/bodies/box_tree.h"

#include <algorithm>
#include <numeric>

namespace netpocket {

BoxTree::BoxTree(std::vector<Eigen::AlignedBox3d> boxes) : boxes_(std::move(boxes)), order_(boxes_.size()) {
  if (boxes_.empty()) return;
  std::iota(order_.begin(), order_.end(), 0);
  nodes_.emplace_back();
  build(0, 0, static_cast<std::int32_t>(order_.size()));
}

// Divides the boxes in two halves by their centres, along the longest edge of the box round the centres. So the tree is
// balanced.
void BoxTree::build(std::int32_t node, std::int32_t first, std::int32_t count) {
  constexpr std::int32_t kMostInLeaf = 4;
  Eigen::AlignedBox3d box, centres;
  for (std::int32_t i = first; i < first + count; ++i) {
    box.extend(boxes_[order_[i]]);
    centres.extend(boxes_[order_[i]].center());
  }
  nodes_[node].box = box;
  if (count <= kMostInLeaf) {
    nodes_[node].first = first;
    nodes_[node].count = count;
    return;
  }
  int axis = 0;
  centres.sizes().maxCoeff(&axis);
  const auto begin = order_.begin() + first;
  std::nth_element(begin, begin + count / 2, begin + count, [&](std::int32_t a, std::int32_t b) {
    return std::pair(boxes_[a].center()[axis], a) < std::pair(boxes_[b].center()[axis], b);
  });
  const auto child = static_cast<std::int32_t>(nodes_.size());
  nodes_[node].first = child;
  nodes_.resize(nodes_.size() + 2);
  build(child, first, count / 2);
  build(child + 1, first + count / 2, count - count / 2);
}

}  // namespace netpocket
