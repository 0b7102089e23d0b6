// V4: ropes wound in and let out.

#include "engine/dynamics/ropes/rope_dynamics.h"

#include "tests/engine/dynamics/models.h"
#include "tests/engine/verification_table.h"

namespace netpocket {
namespace {

using namespace test;

// A mass of 1 kg on a light rope whose retractor is a fixed hook; length L(t) = L0 + rate t.
struct ReeledPendulum {
  ReeledPendulum(double length, double rate, double angle, int elements)
      : cable(straight_cable(plain_cable(8e4, 0, 2e-4), {0, 0, 0},
                             {length * std::sin(angle), -length * std::cos(angle), 0}, elements)) {
    Model& model = cable.model;
    model.fix_node(cable.nodes.front());
    model.nodes[cable.nodes.back()].point_mass = 1;
    model.ropes.push_back({cable.elements, {length, rate}, 1.0});
    // The mass starts along the rope with the speed of winding.
    const Eigen::Vector3d along(std::sin(angle), -std::cos(angle), 0);
    for (int i = 0; i <= elements; ++i) model.nodes[cable.nodes[i]].velocity = along * (rate * i / elements);
  }

  double angle(const CableSystem& system) const {
    const Eigen::Vector3d p = system.position(cable.nodes.back());
    return std::atan2(p.x(), -p.y());
  }

  Cable cable;
};

class VerificationRope : public VerificationTest {
 protected:
  void expect_swing(double length, double rate, double at5, double at10) {
    ReeledPendulum pendulum(length, rate, 0.1, 2);
    pendulum.cable.model.gravity = {0, -9.81, 0};
    CableSystem system(pendulum.cable.model);
    const double dt = 2e-5;
    const std::string what = rate > 0 ? "let out: angle at " : "reeled in: angle at ";
    const std::string source =
        "verification case V4, which is the solution of (L^2 theta')' + g L sin(theta) = 0 from 0.1 rad (the linear "
        "one "
        "differs by 7 % at 5 s); the rope has 0.02 % of the mass and stretches by 0.01 %";
    advance(system, 5, dt);
    expect_value("pendulum " + what + "5 s, rad", pendulum.angle(system), at5, 1e-4, source);
    advance(system, 10, dt);
    expect_value("pendulum " + what + "10 s, rad", pendulum.angle(system), at10, 1e-4, source);
    const EnergyAudit audit = system.audit();
    expect_below("energy error / work of winding m g, " + what.substr(0, what.find(':')), std::abs(audit.error) / 9.81,
                 1e-7, "the power of winding is that of the lumped rope: what is left is the step");
  }
};

TEST_F(VerificationRope, PendulumLetOut) { expect_swing(1, 0.1, .006658320, .042325574); }
TEST_F(VerificationRope, PendulumReeledIn) { expect_swing(2, -0.1, .095687609, .117056428); }

TEST_F(VerificationRope, SpinUpWithoutGravity) {
  ReeledPendulum pendulum(2, -0.1, 0, 2);
  for (std::size_t i = 0; i < pendulum.cable.nodes.size(); ++i) {
    ModelNode& node = pendulum.cable.model.nodes[pendulum.cable.nodes[i]];
    node.velocity += Eigen::Vector3d(-node.position.y(), node.position.x(), 0);  // 1 rad/s
  }
  CableSystem system(pendulum.cable.model);
  const double dt = 2e-5;
  double turned = 0, before = 0;
  while (system.time() < 10 - 0.5 * dt) {
    for (int i = 0; i < 1000; ++i) system.step(dt);
    const double now = pendulum.angle(system);
    turned += std::remainder(now - before, 2 * M_PI);
    before = now;
  }
  const auto mass = pendulum.cable.nodes.back();
  const Eigen::Vector3d p = system.position(mass), v = system.velocity(mass);
  const std::string source =
      "angular momentum of the mass: L^2 w constant (verification case V4); the rope has 0.04 % "
      "of the mass and stretches by up to 0.02 %";
  expect_value("spin-up: angle after 10 s, rad", turned, 20, 0.01, source);
  expect_value("spin-up: angular velocity after 10 s, rad/s", (p.x() * v.y() - p.y() * v.x()) / p.squaredNorm(), 4,
               0.005, source);
}

TEST_F(VerificationRope, MassIsConserved) {
  Cable cable = straight_cable(net_cord(), {0, 0, 0}, {5, 0, 0}, 4);
  cable.model.ropes.push_back({cable.elements, {5, -0.4}, 0.3});
  const CoordinateLayout layout{static_cast<std::int32_t>(cable.model.nodes.size()),
                                static_cast<std::int32_t>(cable.model.gradients.size())};
  std::vector<BatchElement> elements;
  for (const ModelElement& e : cable.model.elements) {
    elements.push_back({{layout.position(e.node1), layout.gradient(e.gradient1), layout.position(e.node2),
                         layout.gradient(e.gradient2)},
                        e.length,
                        cable.model.materials[e.material].section,
                        true});
  }
  ElementBatch batch(elements);
  RopeDynamics ropes(cable.model, layout);
  double largest = 0;
  for (int i = 0; i <= 100; ++i) {
    std::vector<double> mass(layout.size(), 0.0);
    ASSERT_TRUE(ropes.refresh_spans());
    ropes.update(batch, mass);
    ropes.finish_step(0.1);
    double total = 0;
    for (std::int32_t node = 0; node < layout.node_count; ++node) total += mass[layout.position(node)];
    largest = std::max(largest, std::abs(total / cable.model.cable_mass() - 1));
  }
  expect_below("rope and wound mass, relative change", largest, 1e-14, "round-off of a sum of seven");
}

}  // namespace
}  // namespace netpocket
