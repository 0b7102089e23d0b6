#include "engine/model/reorder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "engine/dynamics/system/cable_system.h"

namespace netpocket {
namespace {

// Two crossing cords, of which one is a rope, with a hinge, a line, a rope through a ring and a loose mass.
Model crossing_cords() {
  Model model;
  model.add_material(
      {.section = {.EA = 1000, .EI = 0.1, .mass_per_length = 0.1}, .radius = 0.005, .youngs_modulus = 1e9});
  const std::int32_t left = model.add_node({-1, 0, 0}), right = model.add_node({1, 0, 0});
  const auto across = model.add_straight_cable(left, right, 4, 0);
  const std::int32_t middle = model.elements[static_cast<std::size_t>(across[1])].node2;
  const std::int32_t top = model.add_node({0, 1, 0});
  const auto up = model.add_straight_cable(middle, top, 3, 0);
  model.nodes[static_cast<std::size_t>(top)].velocity = {0.3, 0.2, 0.1};
  model.pair(across[0], across[1]);
  model.hinges.push_back({.gradient1 = model.elements[static_cast<std::size_t>(across[1])].gradient2,
                          .gradient2 = model.elements[static_cast<std::size_t>(up[0])].gradient1,
                          .rest_rotation = Eigen::Matrix3d::Identity(),
                          .stiffness = 0.5,
                          .damping = 0.01});
  model.lines.push_back({.node1 = left, .node2 = top, .length = 1.4, .stiffness = 10, .damping = 0});
  model.ropes.push_back({.elements = up, .motion = {.length = 1, .rate = -0.05}});
  model.ring_ropes.push_back(
      {.nodes = {right, middle, top}, .lengths = {1, 1}, .stiffness = 100, .damping = 1e-3, .friction = 0.1});
  model.node_groups = {{"ends", NodeLook::reel, {left, right, top}}};
  model.fix_node(left);
  return model;
}

std::vector<std::int32_t> shuffled(std::size_t count, std::mt19937& generator) {
  std::vector<std::int32_t> order(count);
  std::iota(order.begin(), order.end(), 0);
  std::ranges::shuffle(order, generator);
  return order;
}

Snapshot after_steps(const Model& model) {
  CableSystem system(model);
  for (int i = 0; i < 2000; ++i) system.step(1e-4);
  Snapshot snapshot;
  system.capture(snapshot);
  return snapshot;
}

TEST(Reorder, AModelInAnotherOrderMovesAlike) {
  const Model model = crossing_cords();
  const Snapshot expected = after_steps(model);
  std::mt19937 generator(3);
  for (int trial = 0; trial < 5; ++trial) {
    Model other = model;
    const NewIndices to =
        reorder(other, {shuffled(model.nodes.size(), generator), shuffled(model.gradients.size(), generator),
                        shuffled(model.elements.size(), generator)});
    EXPECT_EQ(other.find_fault(), std::nullopt);
    const Snapshot found = after_steps(other);
    for (std::size_t i = 0; i < model.nodes.size(); ++i) {
      const auto index = static_cast<Eigen::Index>(i);
      EXPECT_LT((found.positions.col(to.nodes[i]) - expected.positions.col(index)).norm(), 1e-10);
    }
    for (std::size_t i = 0; i < model.elements.size(); ++i) {
      EXPECT_NEAR(found.tension[to.elements[i]], expected.tension[static_cast<Eigen::Index>(i)], 1e-7);
    }
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(other.node_groups[0].nodes[i], to.nodes[static_cast<std::size_t>(model.node_groups[0].nodes[i])]);
    }
  }
  EXPECT_GT((expected.positions.col(0) - expected.positions.col(1)).norm(), 1);
}

}  // namespace
}  // namespace netpocket
