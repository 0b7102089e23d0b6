// Model::find_fault: a model that cannot be stepped says why before it is.
#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "engine/dynamics/system/cable_system.h"
#include "engine/model/model.h"

namespace netpocket {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

// Two elements in a row as strain partners, a body, a hinge between two cables, a rope of one element.
Model sound_model() {
  Model model;
  const auto material = model.add_material({.section = {.EA = 1e4, .EI = 1e-3, .mass_per_length = 1e-3}});
  const auto a = model.add_node({0, 0, 0}), b = model.add_node({2, 0, 0}), c = model.add_node({2, 3, 0});
  const auto chain = model.add_straight_cable(a, b, 2, material);
  model.pair(chain[0], chain[1]);
  const auto across = model.add_straight_cable(b, c, 1, material);
  model.hinges.push_back({.gradient1 = model.elements[chain[1]].gradient2,
                          .gradient2 = model.elements[across[0]].gradient1,
                          .rest_rotation = Eigen::Matrix3d::Identity(),
                          .stiffness = 1,
                          .damping = 0});
  const auto d = model.add_node({4, 3, 0});
  VariableRope rope;
  rope.elements = model.add_straight_cable(c, d, 1, material);
  rope.motion.length = 2;
  model.ropes.push_back(rope);
  model.add_body({.name = "body",
                  .shape = Sphere{1},
                  .mass = 3,
                  .inertia = 1.2 * Eigen::Matrix3d::Identity(),
                  .state = {.position = {0, 9, 0}}});
  return model;
}

std::string fault_after(const std::function<void(Model&)>& change) {
  Model model = sound_model();
  change(model);
  const auto fault = model.find_fault();
  EXPECT_EQ(fault.has_value(), [&] {
    try {
      CableSystem system(model);
      return false;
    } catch (const std::invalid_argument& error) {
      return error.what() == fault.value_or("");
    }
  }()) << "a system refuses the model with the same sentence";
  return fault.value_or("");
}

TEST(FindFault, ASoundModelHasNone) {
  EXPECT_EQ(fault_after([](Model&) {}), "");
  EXPECT_FALSE(Model().find_fault());
}

TEST(FindFault, NamesIndicesThatDoNotExist) {
  EXPECT_EQ(fault_after([](Model& m) { m.elements[1].node2 = 99; }), "element 1 joins a node that does not exist");
  EXPECT_EQ(fault_after([](Model& m) { m.elements[1].gradient1 = -1; }),
            "element 1 has a gradient that does not exist");
  EXPECT_EQ(fault_after([](Model& m) { m.elements[0].gradient1 = 2; }), "element 0 has a gradient of another node");
  EXPECT_EQ(fault_after([](Model& m) { m.elements[0].node2 = m.elements[0].node1; }),
            "element 0 joins a node to itself");
  EXPECT_EQ(fault_after([](Model& m) { m.elements[2].material = 1; }),
            "element 2 is of a material that does not exist");
  EXPECT_EQ(fault_after([](Model& m) { m.elements[2].group = 1; }), "element 2 belongs to a group that does not exist");
  EXPECT_EQ(fault_after([](Model& m) { m.elements[2].thread = 7; }),
            "element 2 belongs to a thread that does not exist");
  EXPECT_EQ(fault_after([](Model& m) { m.gradients[3].node = 70; }),
            "gradient 3 belongs to a node that does not exist");
  EXPECT_EQ(fault_after([](Model& m) { m.hinges[0].gradient2 = 70; }), "hinge 0 joins a gradient that does not exist");
  EXPECT_EQ(fault_after([](Model& m) { m.hinges[0].gradient2 = 0; }), "hinge 0 joins gradients of two nodes");
  EXPECT_EQ(fault_after([](Model& m) { m.hinges[0].body = 1; }), "hinge 0 turns with a body that does not exist");
  EXPECT_EQ(fault_after([](Model& m) { m.ropes[0].elements = {44}; }), "rope 0 has an element that does not exist");
  EXPECT_EQ(fault_after([](Model& m) {
              m.node_groups = {{"tips", NodeLook::nothing, {1, 50}}};
            }),
            "group of nodes 0 names a node that does not exist");
  EXPECT_EQ(fault_after([](Model& m) {
              m.nodes[1].support = Support::body;
              m.nodes[1].body = 1;
            }),
            "node 1 is held by a body that does not exist");
}

TEST(FindFault, NamesNumbersThatCannotBe) {
  EXPECT_EQ(fault_after([](Model& m) { m.nodes[2].position.y() = kNone; }),
            "node 2 has a position or velocity that is not finite");
  EXPECT_EQ(fault_after([](Model& m) { m.nodes[2].point_mass = -1; }), "node 2 has a negative or infinite mass");
  EXPECT_EQ(fault_after([](Model& m) { m.materials[0].section.EA = 0; }), "material 0 has no axial stiffness");
  EXPECT_EQ(fault_after([](Model& m) { m.materials[0].section.mass_per_length = 0; }),
            "material 0 has no mass per length");
  EXPECT_EQ(fault_after([](Model& m) { m.materials[0].section.compression = 2; }),
            "material 0 has a compression outside 0 to 1");
  EXPECT_EQ(fault_after([](Model& m) { m.elements[3].length = 0; }), "element 3 has no length");
  EXPECT_EQ(fault_after([](Model& m) { m.bodies[0].mass = 0; }), "body 0 has no mass");
  EXPECT_EQ(fault_after([](Model& m) { m.bodies[0].inertia(2, 2) = -1; }),
            "body 0 has an inertia that is not positive definite");
  EXPECT_EQ(fault_after([](Model& m) { m.hinges[0].stiffness = kNone; }),
            "hinge 0 has a negative or infinite stiffness or damping");
  EXPECT_EQ(fault_after([](Model& m) { m.ropes[0].motion.length = 0; }), "rope 0 has no length at the start");
  EXPECT_EQ(fault_after([](Model& m) { m.ropes[0].motion.rate = std::nan(""); }),
            "rope 0 has a rate or acceleration that is not finite");
  EXPECT_EQ(fault_after([](Model& m) { m.ropes[0].share_at_start = 1.5; }),
            "rope 0 has a share at its start outside 0 to 1");
}

TEST(FindFault, StrainPartnersMatch) {
  EXPECT_EQ(fault_after([](Model& m) { m.elements[0].strain_partner = 55; }),
            "element 0 has a strain partner that does not exist");
  EXPECT_EQ(fault_after([](Model& m) { m.elements[1].strain_partner = -1; }),
            "element 0 is not its strain partner's partner");
  EXPECT_EQ(fault_after([](Model& m) { m.elements[1].length = 0.9; }),
            "element 0 has a strain partner of another length or material");
}

}  // namespace
}  // namespace netpocket
