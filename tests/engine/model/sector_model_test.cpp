// One sector of a model: what it holds, how copies are tied, and what is no sector.

#include "engine/model/sector_model.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <set>

#include "engine/math/block_size.h"

namespace netpocket {
namespace {

CableMaterial cord() {
  CableMaterial material;
  material.section = {.EA = 1000, .EI = 1e-3, .mass_per_length = 0.01};
  material.radius = 0.002;
  material.youngs_modulus = 1e9;
  return material;
}

// A wheel without a hub: spokes of one element from an inner to an outer ring, and an outer ring of paired elements.
Model wheel(int sectors) {
  Model model;
  const std::int32_t material = model.add_material(cord());
  const auto at = [&](double radius, double part) {
    const double angle = 2 * std::numbers::pi * part / sectors;
    return Eigen::Vector3d(radius * std::cos(angle), 1, radius * std::sin(angle));
  };
  for (int s = 0; s < sectors; ++s) model.add_node(at(1, s));
  for (int s = 0; s < sectors; ++s) model.add_node(at(2, s));
  for (int s = 0; s < sectors; ++s) model.add_node(0.5 * (at(2, s) + at(2, s + 1)));
  const auto add_gradients = [&](int first_node, const auto& direction, bool of_next) {
    for (int s = 0; s < sectors; ++s) {
      model.add_gradient(first_node + (of_next ? (s + 1) % sectors : s), direction(s).normalized());
    }
  };
  const auto outwards = [&](int s) -> Eigen::Vector3d { return at(1, s) - Eigen::Vector3d(0, 1, 0); };
  const auto along = [&](int s) -> Eigen::Vector3d { return at(2, s + 1) - at(2, s); };
  add_gradients(0, outwards, false);
  add_gradients(sectors, outwards, false);
  add_gradients(sectors, along, false);
  add_gradients(2 * sectors, along, false);
  add_gradients(sectors, along, true);
  const double side = std::sin(std::numbers::pi / sectors) * 2;
  for (int s = 0; s < sectors; ++s) model.add_element({s, s, sectors + s, sectors + s, 1, material});
  for (int s = 0; s < sectors; ++s) {
    model.add_element({sectors + s, 2 * sectors + s, 2 * sectors + s, 3 * sectors + s, side, material});
  }
  for (int s = 0; s < sectors; ++s) {
    model.add_element({2 * sectors + s, 3 * sectors + s, sectors + (s + 1) % sectors, 4 * sectors + s, side, material});
    model.pair(sectors + s, 2 * sectors + s);
  }
  return model;
}

TEST(SectorTurn, IsExactUnderQuarterTurns) {
  const SectorTurn turn(8);
  EXPECT_EQ(turn(2, {3, 5, 7}), Eigen::Vector3d(-7, 5, 3));
  EXPECT_EQ(turn(-2, {3, 5, 7}), Eigen::Vector3d(7, 5, -3));
  EXPECT_EQ(turn(1, {1, 0, 0}).x(), turn(1, {1, 0, 0}).z());
}

TEST(SectorTurn, TurnsByTheAngleOfASector) {
  const SectorTurn turn(7);
  for (int i = -6; i < 7; ++i) {
    const double angle = 2 * std::numbers::pi * i / 7;
    EXPECT_NEAR(turn(i, {1, 0, 0}).x(), std::cos(angle), 1e-15);
    EXPECT_NEAR(turn(i, {1, 0, 0}).z(), std::sin(angle), 1e-15);
  }
}

TEST(SectorModel, HoldsEachElementOfASectorOnce) {
  for (const int sectors : {3, 6, 8, 11}) {
    const Model whole = wheel(sectors);
    ASSERT_FALSE(find_asymmetry(whole, sectors)) << *find_asymmetry(whole, sectors);
    const SectorModel sector = sector_model(whole, sectors);
    std::multiset<std::int32_t> held;
    for (const std::int32_t element : sector.element_of) {
      if (element >= 0) held.insert(element);
    }
    EXPECT_EQ(held, (std::multiset<std::int32_t>{0, sectors, 2 * sectors}));
    EXPECT_EQ(sector.model.elements.size() % kBlockSize, 0u);
    // The outer end of the spoke and the ring's two ends are one node of this sector, the last turned by one.
    ASSERT_EQ(sector.ties.size(), 2u);
    std::multiset<int> turns;
    for (const SectorModel::Tie& tie : sector.ties) {
      turns.insert(tie.turns);
      const Eigen::Vector3d image =
          SectorTurn(sectors)(tie.turns, sector.model.nodes[static_cast<std::size_t>(tie.leader)].position);
      EXPECT_LT((sector.model.nodes[static_cast<std::size_t>(tie.follower)].position - image).norm(), 1e-14);
    }
    EXPECT_EQ(turns, (std::multiset<int>{0, 1}));
  }
}

TEST(SectorModel, PairsStandInTheSameLane) {
  const SectorModel sector = sector_model(wheel(8), 8);
  for (std::size_t i = 0; i < sector.element_of.size(); ++i) {
    const std::int32_t partner = sector.model.elements[i].strain_partner;
    if (sector.element_of[i] == 8) {
      EXPECT_EQ(partner, static_cast<std::int32_t>(i) + kBlockSize);
    }
    if (sector.element_of[i] == 0) {
      EXPECT_EQ(partner, -1);
    }
  }
}

TEST(FindAsymmetry, TellsWhatDiffers) {
  const auto reason = [](const std::function<void(Model&)>& change) {
    Model model = wheel(8);
    change(model);
    return find_asymmetry(model, 8).value_or("symmetric");
  };
  EXPECT_EQ(reason([](Model&) {}), "symmetric");
  EXPECT_EQ(reason([](Model& m) { m.nodes[3].position.y() += 1e-7; }),
            "node 3 is not the turned node of the sector before");
  EXPECT_EQ(reason([](Model& m) { m.nodes[3].position.y() += 1e-12; }), "symmetric");
  EXPECT_EQ(reason([](Model& m) { m.gradients[12].value *= 1.001; }),
            "gradient 12 is not the turned gradient of the sector before");
  EXPECT_EQ(reason([](Model& m) { m.elements[10].length *= 1 + 1e-6; }), "cable differs from cable");
  EXPECT_EQ(reason([](Model& m) { m.gravity = {0, -9.81, 0}; }), "symmetric");
  EXPECT_EQ(reason([](Model& m) { m.gravity = {0.1, -9.81, 0}; }), "gravity acts across the axis");
  EXPECT_EQ(reason([](Model& m) {
              m.lines.push_back({0, 1, 1, 1, 1});
            }),
            "lines, ropes through rings and locked bodies have no sectors");
  EXPECT_EQ(reason([](Model& m) { m.add_node({0, 0, 0}); }), "sectors have different numbers of parts");
  const auto with_body = [&](const Eigen::Vector3d& position, const Eigen::Matrix3d& inertia) {
    return reason([&](Model& m) {
      m.add_body({.name = "ball", .shape = Sphere{1}, .mass = 1, .inertia = inertia, .state = {.position = position}});
    });
  };
  const Eigen::Matrix3d round = Eigen::Matrix3d::Identity();
  Eigen::Matrix3d skew = round;
  skew(0, 1) = skew(1, 0) = 0.1;
  EXPECT_EQ(with_body({0, 3, 0}, round), "symmetric");
  EXPECT_EQ(with_body({1e-6, 3, 0}, round), "the ball is not on the axis or does not move along it");
  EXPECT_EQ(with_body({0, 3, 0}, skew), "the axis is no principal axis of the ball");
}

}  // namespace
}  // namespace netpocket
