#pragma once
// A tree of boxes that finds the boxes that intersect a given one. Immutable: any thread may use it.

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

namespace netpocket {

class BoxTree {
 public:
  explicit BoxTree(std::vector<Eigen::AlignedBox3d> boxes);

  // Calls visit(index) for each box that intersects `box`. The order is arbitrary but always the same.
  template <typename Visit>
  void for_each_meeting(const Eigen::AlignedBox3d& box, const Visit& visit) const {
    if (nodes_.empty()) return;
    std::vector<std::int32_t> left = {0};
    while (!left.empty()) {
      const Node& node = nodes_[left.back()];
      left.pop_back();
      if (!node.box.intersects(box)) continue;
      if (node.count == 0) {
        left.push_back(node.first);
        left.push_back(node.first + 1);
      }
      for (std::int32_t i = node.first; i < node.first + node.count; ++i) {
        if (boxes_[order_[i]].intersects(box)) visit(order_[i]);
      }
    }
  }

 private:
  struct Node {
    Eigen::AlignedBox3d box;
    std::int32_t first = 0;  // first box in order_, or first of two adjacent children
    std::int32_t count = 0;  // number of boxes; 0: the node has children
  };
  void build(std::int32_t node, std::int32_t first, std::int32_t count);

  std::vector<Eigen::AlignedBox3d> boxes_;
  std::vector<std::int32_t> order_;
  std::vector<Node> nodes_;
};

}  // namespace netpocket
