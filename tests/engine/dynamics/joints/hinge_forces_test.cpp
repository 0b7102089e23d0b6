// Hinges: moment and rotation, the plane of the joint, balance of moments.

#include "engine/dynamics/joints/hinge_forces.h"

#include "tests/engine/dynamics/models.h"
#include "tests/engine/verification_table.h"

namespace netpocket {
namespace {

using namespace test;

// Two rods of 1 m in the xy plane, the second at 0.5 rad to the first; the first is clamped at its root.
struct KinkedRod {
  std::int32_t kink, tip;
  Hinge hinge;
  Model model;

  explicit KinkedRod(double EI, double stiffness) {
    const double bend = 0.5, length = 1;
    const auto root = model.add_node({0, 0, 0});
    kink = model.add_node({length, 0, 0});
    tip = model.add_node({length + length * std::cos(bend), length * std::sin(bend), 0});
    CableMaterial material = plain_cable(2e4, EI, 0.5);
    material.section.axial_damping = 1e-5;
    material.section.bending_damping = 2e-2;
    const auto rod = model.add_material(material);
    const auto first = model.add_straight_cable(root, kink, 4, rod);
    const auto second = model.add_straight_cable(kink, tip, 4, rod);
    root_gradient = model.elements[first.front()].gradient1;
    hinge = {model.elements[first.back()].gradient2,
             model.elements[second.front()].gradient1,
             Eigen::AngleAxisd(bend, Eigen::Vector3d::UnitZ()).toRotationMatrix(),
             -1,
             stiffness,
             0.2};
    model.hinges.push_back(hinge);
    this->root = root;
  }
  void clamp() {
    model.fix_node(root);
    model.fix_gradient(root_gradient);
  }
  std::int32_t root = 0, root_gradient = 0;
};

class VerificationHinge : public VerificationTest {};

TEST_F(VerificationHinge, MomentEqualsStiffnessTimesAngle) {
  const double stiffness = 30;
  for (const auto& [load, what] :
       {std::pair{Eigen::Vector3d(2, -6, 0), "in its plane"}, {Eigen::Vector3d(1, -3, 4), "out of its plane"}}) {
    KinkedRod rod(200, stiffness);
    rod.clamp();
    rod.model.nodes[rod.tip].load = load;
    CableSystem system = relax(rod.model, {}, 1e-11);
    const Eigen::Vector3d g1 = system.gradient(rod.hinge.gradient1), g2 = system.gradient(rod.hinge.gradient2);
    const Eigen::Vector3d zero = Eigen::Vector3d::Zero();
    const HingeForces forces = hinge_forces(rod.hinge, g1, g2, zero, zero, Eigen::Matrix3d::Identity(), zero);
    const Eigen::Vector3d arm = system.position(rod.tip) - system.position(rod.kink);
    const Eigen::Vector3d across = (rod.hinge.rest_rotation * g1).cross(g2).normalized();
    const Eigen::Vector3d moment = stiffness * forces.angle * across;
    // A cable element takes no torsion: the moment along the second rod's tangent is not transmitted.
    const Eigen::Vector3d tangent = g2.normalized();
    const Eigen::Vector3d applied = arm.cross(load) - tangent.dot(arm.cross(load)) * tangent;
    expect_below(std::string("hinge loaded ") + what + ": difference of k theta and the moment of the load, relative",
                 (moment - applied).norm() / applied.norm(), 2e-3,
                 "statics, by relaxation to 1e-11 J; angle " + std::to_string(forces.angle).substr(0, 5) + " rad");
    if (load.z() == 0) {
      EXPECT_EQ(system.position(rod.tip).z(), 0);
    }
  }
}

// A fold so violent that a slope vanishes: its direction is undefined, so it must not matter.
TEST(Hinge, LetsGoOfASlopeThatVanishes) {
  const Hinge hinge = KinkedRod(200, 30).hinge;
  const Eigen::Vector3d zero = Eigen::Vector3d::Zero(), way(0.6, 0, 0.8), other(-0.9, 0.3, 0.2);
  const auto at = [&](const Eigen::Vector3d& g1, const Eigen::Vector3d& g2) {
    return hinge_forces(hinge, g1, g2, zero, zero, Eigen::Matrix3d::Identity(), zero);
  };
  double difference = 0;
  for (const double length : {1e-3, 0.1, 0.3, 0.45, 1.0}) {
    const Eigen::Vector3d g1 = length * way, g2 = 0.4 * other;
    for (int axis = 0; axis < 3; ++axis) {
      const Eigen::Vector3d d = 1e-6 * length * Eigen::Vector3d::Unit(axis);
      const double on1 = -(at(g1 + d, g2).energy - at(g1 - d, g2).energy) / (2 * d[axis]);
      const double on2 = -(at(g1, g2 + d).energy - at(g1, g2 - d).energy) / (2 * d[axis]);
      difference = std::max(difference, std::abs(on1 - at(g1, g2).on_gradient1[axis]));
      difference = std::max(difference, std::abs(on2 - at(g1, g2).on_gradient2[axis]));
    }
  }
  EXPECT_LT(difference, 1e-5);  // N m; differences of 1e-6
  EXPECT_LT(at(1e-6 * way, other).on_gradient1.norm(), 1e-2);
  EXPECT_LT(at(1e-6 * way, other).energy, 1e-9);
}

TEST_F(VerificationHinge, DeflectionAgreesWithBeamTheory) {
  // Small load across the second rod at its tip: both rods bend, the hinge turns, superposed.
  const double EI = 200, stiffness = 30, force = 0.02, bend = 0.5;
  KinkedRod rod(EI, stiffness);
  rod.clamp();
  const Eigen::Vector3d across(-std::sin(bend), std::cos(bend), 0), along(std::cos(bend), std::sin(bend), 0);
  rod.model.nodes[rod.tip].load = force * across;
  const Eigen::Vector3d start = rod.model.nodes[rod.tip].position;
  CableSystem system = relax(rod.model, {}, 1e-15);
  // First rod: tip force F cos(bend) across it and moment F L; the second: cantilever turned by the first's slope.
  const double moment = force, shear = force * std::cos(bend);
  const double slope = shear / (2 * EI) + moment / EI, sag = shear / (3 * EI) + moment / (2 * EI);
  const double deflection = sag * std::cos(bend) + slope + moment / stiffness + force / (3 * EI);
  expect_relative("kinked cantilever: deflection across the second rod, m",
                  (system.position(rod.tip) - start).dot(across), deflection, 5e-3,
                  "beam theory, superposition of two cantilevers and the hinge; four elements a rod");
}

TEST_F(VerificationHinge, KeepsMomentum) {
  KinkedRod rod(20, 30);
  rod.model.nodes[rod.tip].velocity = {0, 1, 2};
  // The rest rotation's axes move with the body, which takes the moment.
  rod.model.add_body(
      {.name = "hub", .shape = Sphere{0.1}, .mass = 2, .inertia = 0.1 * Eigen::Matrix3d::Identity(), .state = {}});
  rod.model.clamp_to_body(rod.root, rod.root_gradient, 0);
  rod.model.hinges[0].body = 0;
  CableSystem system(rod.model);
  const MomentumDrift drift = run_and_measure_drift(system, 1, 0.5 * system.stable_step().step);
  const std::string source = "free system: the hinge's moments on two gradients and the body sum to zero; round-off";
  expect_below("linear momentum of a kinked rod on a free body, relative drift", drift.linear, 1e-10, source);
  expect_below("angular momentum of a kinked rod on a free body, relative drift", drift.angular, 1e-10, source);
}

}  // namespace
}  // namespace netpocket
