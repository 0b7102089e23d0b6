// The pocket that a scenario describes: dimensions, masses, mesh.

#include "engine/systems/pocket/pocket.h"

#include <map>
#include <numbers>

#include "engine/state/pocket_groups.h"
#include "tests/engine/dynamics/models.h"
#include "tests/engine/verification_table.h"

namespace netpocket {
namespace {

class VerificationPocket : public test::VerificationTest {
 protected:
  const Pocket pocket_ = build_pocket(Scenario{});
  const Model& model_ = pocket_.model;
  Eigen::Vector3d position(std::int32_t node) const { return model_.nodes[node].position; }
};

TEST_F(VerificationPocket, HasThePapersDimensions) {
  const std::vector<std::int32_t>& tips = pocket_.structure.nodes(kRodTips);
  ASSERT_EQ(tips.size(), 8u);
  const Eigen::Vector3d first = position(tips[0]), next = position(tips[1]);
  const std::string source = "Tang et al. (2023), section ";
  expect_value("diameter at the mouth, m", 2 * std::hypot(first.x(), first.z()), 15.12, 1e-12, source + "2");
  expect_value("depth, m", first.y(), 12, 1e-12, source + "2");
  expect_value("open distance between rod tips, m", (next - first).norm(), 5.78, 0.01, source + "4.1, three digits");
  for (const VariableRope& rope : model_.ropes) {
    EXPECT_NEAR(rope.motion.length, (next - first).norm(), 1e-12);
    EXPECT_EQ(rope.motion.rate, 0);
  }
}

TEST_F(VerificationPocket, StartsFreeOfStress) {
  CableSystem system(model_);
  Snapshot snapshot;
  system.capture(snapshot);
  expect_below("largest tension in the pocket as built / EA", snapshot.tension.cwiseAbs().maxCoeff() / 150796, 1e-14,
               "threads start at their natural length: round-off");
  double bending = 0;  // two cubics of half a side's length that rise by `rise` with no slope at their ends
  const double stiffness = 12e9 * std::numbers::pi / 64 * std::pow(0.004, 4), rise = Scenario{}.pocket.bow;
  for (const ModelElement& e : model_.elements) {
    if (e.group == index_of(PocketGroup::net)) bending += 24 * stiffness * rise * rise / e.length;
  }
  expect_relative("strain energy of the pocket as built, J", system.audit().strain, bending, 1e-3,
                  "bending of mesh sides that rise by a thousandth of their length, 6 EI f^2/l^3 an element");

  Scenario straight;
  straight.pocket.bow = 0;
  expect_below("strain energy of a pocket of straight cords as built, J",
               CableSystem(build_pocket(straight).model).audit().strain, 1e-18, "round-off");
}

TEST_F(VerificationPocket, ElementsJoinTheirNodesAndGradients) {
  std::map<PocketGroup, double> length;
  for (const ModelElement& e : model_.elements) {
    EXPECT_EQ(model_.gradients[e.gradient1].node, e.node1);
    EXPECT_EQ(model_.gradients[e.gradient2].node, e.node2);
    EXPECT_NEAR((position(e.node2) - position(e.node1)).norm(), e.length, 1e-6 * e.length);  // bowed by a thousandth
    length[static_cast<PocketGroup>(e.group)] += e.length;
  }
  // 8 rods from (0.6, 0) over (4.8, 5.3) to (7.56, 12).
  const double lower = std::hypot(4.2, 5.3), upper = std::hypot(2.76, 6.7);
  EXPECT_NEAR(length[PocketGroup::rods], 8 * (lower + upper), 1e-10);
  const auto tube = [](double wall) {
    return 164 * std::numbers::pi / 4 * (0.01 - (0.1 - 2 * wall) * (0.1 - 2 * wall));
  };
  const double cord = 1430 * std::numbers::pi / 4 * 0.004 * 0.004;
  expect_relative("mass of rods, net and ropes, kg", model_.cable_mass(),
                  8 * (lower * tube(0.0015) + upper * tube(0.001)) +
                      cord * (length[PocketGroup::net] + length[PocketGroup::closing_ropes]),
                  1e-12, "densities, sections and lengths from the paper and the scenario");
}

TEST_F(VerificationPocket, RepeatsEverySector) {
  // Turning by two sectors is (x, z) -> (-z, x), to the last bit.
  for (std::size_t i = 0; i < model_.nodes.size(); ++i) {
    const Eigen::Vector3d here = model_.nodes[i].position;
    const Eigen::Vector3d there = model_.nodes[i / 8 * 8 + (i + 2) % 8].position;
    ASSERT_EQ(there, Eigen::Vector3d(-here.z(), here.y(), here.x())) << "node " << i;
  }
}

}  // namespace
}  // namespace netpocket
