#pragma once
// Nets of straight cords that are made by hand, so that their metrics are known.

#include <iterator>
#include <string>
#include <vector>

#include "engine/state/pocket_groups.h"
#include "engine/state/snapshot.h"
#include "engine/state/structure.h"

namespace netpocket {

class HandMadeNet {
 public:
  HandMadeNet() {
    structure.element_groups = pocket_groups();
    structure.node_groups = {{kRodTips, NodeLook::reel, {}}};
  }

  std::int32_t add_node(const Eigen::Vector3d& position) {
    positions_.push_back(position);
    return structure.node_count++;
  }

  // A straight element between two nodes.
  void add_cord(std::int32_t from, std::int32_t to, PocketGroup group, std::int32_t thread = 0) {
    const Eigen::Vector3d span =
        positions_.at(static_cast<std::size_t>(to)) - positions_.at(static_cast<std::size_t>(from));
    StructureElement element = {{from, to}, {structure.gradient_count, structure.gradient_count + 1}};
    element.group = index_of(group);
    element.thread = thread;
    element.length = span.norm();
    element.radius = kRadius;
    structure.gradient_count += 2;
    while (std::ssize(structure.threads) <= thread) {
      structure.threads.push_back("thread " + std::to_string(structure.threads.size()));
    }
    structure.elements.push_back(element);
    gradients_.insert(gradients_.end(), 2, span.normalized());
  }

  void add_tip(std::int32_t node) { structure.node_groups.front().nodes.push_back(node); }

  Snapshot snapshot(double time = 0) const {
    Snapshot s;
    s.time = time;
    s.positions.resize(3, structure.node_count);
    s.gradients.resize(3, structure.gradient_count);
    for (std::size_t i = 0; i < positions_.size(); ++i) s.positions.col(static_cast<Eigen::Index>(i)) = positions_[i];
    for (std::size_t i = 0; i < gradients_.size(); ++i) s.gradients.col(static_cast<Eigen::Index>(i)) = gradients_[i];
    s.velocities = Eigen::Matrix3Xd::Zero(3, structure.node_count);
    s.tension = s.strain = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(structure.elements.size()));
    s.bodies.resize(structure.bodies.size());
    s.channel(Channel::time) = time;
    return s;
  }

  static constexpr double kRadius = 0.002;  // m, of every cord

  Structure structure;

 private:
  std::vector<Eigen::Vector3d> positions_, gradients_;
};

// A bag: a square net of 2 x 2 m at y = 0 with meshes of 1 m, walls without cords between, and four ropes round a
// square mouth with sides of `mouth` at y = 2, whose corners are the tips.
inline HandMadeNet hand_made_bag(double mouth = 2) {
  HandMadeNet net;
  std::int32_t grid[3][3];
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) grid[i][j] = net.add_node({i - 1.0, 0, j - 1.0});
  }
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 2; ++j) {
      net.add_cord(grid[i][j], grid[i][j + 1], PocketGroup::net, i);
      net.add_cord(grid[j][i], grid[j + 1][i], PocketGroup::net, 3 + i);
    }
  }
  const double half = mouth / 2;
  std::int32_t corner[4];
  const double x[] = {-half, half, half, -half}, z[] = {-half, -half, half, half};
  for (int i = 0; i < 4; ++i) net.add_tip(corner[i] = net.add_node({x[i], 2, z[i]}));
  for (int i = 0; i < 4; ++i) net.add_cord(corner[i], corner[(i + 1) % 4], PocketGroup::closing_ropes, 6);
  return net;
}

}  // namespace netpocket
