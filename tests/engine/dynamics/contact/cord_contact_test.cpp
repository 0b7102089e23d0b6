// Contact of cords, nets and rods among themselves.

#include <fmt/format.h>

#include <limits>

#include "engine/bodies/segment_distance.h"
#include "engine/dynamics/contact/cord_polyline.h"
#include "tests/engine/dynamics/models.h"
#include "tests/engine/verification_table.h"

namespace netpocket {
namespace {

using namespace test;
using Eigen::Vector3d;

class VerificationCordContact : public VerificationTest {};

CableMaterial damped_cord() {
  CableMaterial cord = net_cord();
  cord.section.axial_damping = 1e-5;
  cord.section.bending_damping = 1e-2;
  return cord;
}

// Adds a straight cord as a thread of its own; returns its nodes.
std::vector<std::int32_t> add_cord(Model& model, std::int32_t material, const Vector3d& begin, const Vector3d& end,
                                   int elements) {
  const std::int32_t first = model.add_node(begin), last = model.add_node(end);
  const auto chain = model.add_straight_cable(first, last, elements, material, 0,
                                              model.add_thread(fmt::format("cord {}", model.threads.size())));
  std::vector<std::int32_t> nodes;
  for (const std::int32_t element : chain) nodes.push_back(model.elements[element].node1);
  nodes.push_back(last);
  return nodes;
}

// Least distance of the axes of elements that share no node, as contact sees them, of the sum of their radii.
double least_clearance(const CableSystem& system) {
  const Model& model = system.model();
  constexpr std::size_t kSegments = CordPolyline::kSegments;
  std::vector<CordPolyline::Vertices> chains;
  for (const ModelElement& e : model.elements) {
    auto& chain = chains.emplace_back();
    for (std::size_t i = 0; i <= kSegments; ++i) {
      const NodalWeights w = shape(2.0 * static_cast<double>(i) / kSegments - 1, e.length);
      chain[i] = w[0] * system.position(e.node1) + w[1] * system.gradient(e.gradient1) +
                 w[2] * system.position(e.node2) + w[3] * system.gradient(e.gradient2);
    }
  }
  const auto share_a_node = [](const ModelElement& e, const ModelElement& f) {
    return e.node1 == f.node1 || e.node1 == f.node2 || e.node2 == f.node1 || e.node2 == f.node2;
  };
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t a = 0; a < chains.size(); ++a) {
    for (std::size_t b = a + 1; b < chains.size(); ++b) {
      const ModelElement &e = model.elements[a], &f = model.elements[b];
      if (share_a_node(e, f)) continue;
      const double thickness = model.materials[e.material].radius + model.materials[f.material].radius;
      for (std::size_t i = 0; i < kSegments; ++i) {
        for (std::size_t j = 0; j < kSegments; ++j) {
          const Segment one{chains[a][i], chains[a][i + 1]}, other{chains[b][j], chains[b][j + 1]};
          least = std::min(least, closest_points(one, other).distance / thickness);
        }
      }
    }
  }
  return least;
}

// Two free cords of 2 m, 8 elements each, that cross at `angle` near their middles: the upper one flies down at
// `speed`.
struct CrossingCords {
  explicit CrossingCords(double speed, double angle = 0.5 * M_PI, double height = 0.05,
                         const CableMaterial& material = damped_cord()) {
    const std::int32_t cord = model.add_material(material);
    const Vector3d across(std::cos(angle), 0, std::sin(angle)), off(0.02, 0, 0.03);
    lower = add_cord(model, cord, {-1, 0, 0}, {1, 0, 0}, 8);
    upper = add_cord(model, cord, off - across + Vector3d(0, height, 0), off + across + Vector3d(0, height, 0), 8);
    for (const std::int32_t node : upper) model.nodes[node].velocity = {0, -speed, 0};
    model.contact.cords = true;
  }
  Model model;
  std::vector<std::int32_t> lower, upper;
};

TEST_F(VerificationCordContact, CordsDoNotPassThroughEachOther) {
  for (const double speed : {1.0, 10.0, 100.0}) {
    std::int64_t stopped = 0;
    for (const double angle : {90.0, 30.0}) {
      double highest = -1;  // of the lower cord's middle against the upper one's
      for (const double height : {0.05, 0.0531, 0.0573, 0.0617}) {
        const CrossingCords cords(speed, angle * M_PI / 180, height);
        CableSystem system(cords.model);
        advance(system, (height + 0.2) / speed, 0.9 * system.stable_step().step);
        ASSERT_FALSE(system.fault()) << *system.fault();
        highest = std::max(highest, system.position(cords.lower[4]).y() - system.position(cords.upper[4]).y());
        stopped += system.safeguards().stopped_cords;
        // What stays where it is does not pass either.
        EXPECT_LT(system.position(cords.upper.front()).y(), 0) << "the upper cord's end has not come down";
      }
      expect_value(
          fmt::format("lower cord's middle above the upper one's, 0.2 m later, {} m/s at {} degrees, m", speed, angle),
          std::max(highest, 0.0), 0, 0.03,
          "two cords of 4 mm that hold each other: the same height but for the slope of cords over the 20 and "
          "30 mm between these nodes and the crossing; 0.2 m if they passed");
    }
    // Springs are made for 1 m/s.
    if (speed < 2) {
      EXPECT_EQ(stopped, 0);
    }
    if (speed > 50) {
      EXPECT_GT(stopped, 0);
    }
  }
}

// Height (m) of a point `along` m after the first node of the element that begins or ends at a node.
double height_in(const CableSystem& system, const ModelElement& e, double along) {
  const NodalWeights w = shape(2 * along / e.length - 1, e.length);
  return w[0] * system.position(e.node1).y() + w[1] * system.gradient(e.gradient1).y() +
         w[2] * system.position(e.node2).y() + w[3] * system.gradient(e.gradient2).y();
}

// Speed of separation (m/s) of two limp cords at their crossing just after they have parted.
double rebound(double speed, double restitution) {
  CableMaterial limp = net_cord();
  limp.section.EI = 1e-6;
  CrossingCords cords(speed, 0.5 * M_PI, 0.05, limp);
  cords.model.contact.restitution = restitution;
  CableSystem system(cords.model);
  const double dt = 0.5 * system.stable_step().step;
  while (system.cord_contacts().count == 0) system.step(dt);
  while (system.cord_contacts().count > 0) system.step(dt);
  // They cross at x = 0.02, z = 0: 0.02 m after the lower cord's middle node, 0.03 m before the upper one's.
  const std::vector<ModelElement>& elements = system.model().elements;
  const ModelElement& below = *std::ranges::find(elements, cords.lower[4], &ModelElement::node1);
  const ModelElement& above = *std::ranges::find(elements, cords.upper[4], &ModelElement::node2);
  // On straight capsules between points of the curves.
  const double capsule = below.length / CordPolyline::kSegments;
  const auto height = [&](const ModelElement& e, double from, double part) {
    return (1 - part) * height_in(system, e, from) + part * height_in(system, e, from + capsule);
  };
  const auto gap = [&] {
    return height(above, above.length - capsule, 1 - 0.03 / capsule) - height(below, 0, 0.02 / capsule);
  };
  const double before = gap();
  system.step(dt);
  return (gap() - before) / dt;
}

TEST_F(VerificationCordContact, Restitution) {
  for (const auto& [restitution, clipped] : {std::pair{0.5, 0.55028}, {1.0, 1.0}}) {
    for (const double speed : {0.3, 1.0, 5.0}) {
      expect_relative(
          fmt::format("rebound of crossing cords, c_r = {}, {} m/s", restitution, speed),
          rebound(speed, restitution) / speed, clipped, 3e-2,
          "Antypov & Elliott (2011) with the adhesive tail cut off; steps of an eighth of an impact, and what "
          "tension the cords gain meanwhile");
    }
  }
}

// A cord that falls obliquely over a rod of 0.1 m and another cord, all free.
Model oblique_fall(double friction, const CableMaterial& material = damped_cord()) {
  Model model;
  const std::int32_t cord = model.add_material(material);
  CableMaterial tube = plain_cable(3.5e5, 430, 0.08);
  tube.radius = 0.05;
  tube.youngs_modulus = 0.75e9;
  tube.poisson_ratio = 0.3;
  const std::int32_t rod = model.add_material(tube);
  add_cord(model, rod, {-1, -0.05, -0.4}, {1, 0.05, 0.3}, 6);
  add_cord(model, cord, {-0.9, 0.1, 0.5}, {0.9, 0.0, 0.5}, 6);
  for (const std::int32_t node : add_cord(model, cord, {-0.3, 0.15, -1}, {0.25, 0.2, 1}, 8)) {
    model.nodes[node].velocity = {2, -3, 0.5};
  }
  model.contact.cords = true;
  model.contact.friction = friction;
  return model;
}

TEST_F(VerificationCordContact, ActionEqualsReaction) {
  for (const double friction : {0.0, 0.4}) {
    CableSystem system(oblique_fall(friction));
    const double dt = 0.8 * system.stable_step().step;
    Momentum last = step_and_measure_momentum(system, dt);
    double linear = 0, angular = 0, force = 0;
    int contacts = 0;
    while (system.time() < 0.3) {
      const Momentum now = step_and_measure_momentum(system, dt);
      linear = std::max(linear, (now.linear - last.linear).norm() / dt);
      angular = std::max(angular, (now.angular - last.angular).norm() / dt);
      force = std::max(force, system.cord_contacts().normal_force);
      contacts += system.cord_contacts().count;
      last = now;
    }
    ASSERT_GT(force, 1);
    ASSERT_GT(contacts, 20);
    const std::string with = friction > 0 ? ", with friction" : ", without friction";
    expect_below("cords and rod: sum of forces / largest contact force" + with, linear / force, 1e-8,
                 "round-off of momentum differences over a step (1e-16/dt^2)");
    expect_below("cords and rod: sum of moments / largest contact force x 1 m" + with, angular / force, 1e-8,
                 "friction's moments about the axes are taken by the cords' bending");
  }
}

TEST_F(VerificationCordContact, EnergyAudit) {
  for (const double friction : {0.0, 0.4}) {
    CableSystem system(oblique_fall(friction, net_cord()));
    const double kinetic = system.audit().kinetic;
    advance(system, 0.3, 0.8 * system.stable_step().step);
    const EnergyAudit audit = system.audit();
    ASSERT_GT(audit.spent.total(), 0.01 * kinetic);
    expect_below(
        fmt::format("energy error / kinetic energy at the start, cord over rod and cord, mu = {}", friction),
        std::abs(audit.error) / kinetic, 1e-2,
        "springs are counted by what they hold: leapfrog's error in impacts of eight steps, and contacts that go "
        "from one capsule to the next");
  }
}

// The clamped end of a rod moves with its body, which a blow there sets in motion within a step.
TEST_F(VerificationCordContact, EnergyAuditOfABlowOnAClampedEnd) {
  CableMaterial rod = plain_cable(1e6, 50, 1);
  rod.radius = 0.02;
  Cable cable = straight_cable(rod, {0, 0, 0}, {0.4, 0, 0}, 1);
  Model& model = cable.model;
  model.add_body({.name = "hub",
                  .shape = Sphere{0.05},
                  .mass = 0.5,
                  .inertia = Vector3d(0.01, 0.01, 0.01).asDiagonal(),
                  .state = {}});
  model.clamp_to_body(cable.nodes.front(), cable.gradients.front(), 0);
  CableMaterial bar = plain_cable(1e6, 50, 5);
  bar.radius = 0.02;
  for (const std::int32_t node : add_cord(model, model.add_material(bar), {0.03, 0.06, -0.4}, {0.03, 0.06, 0.4}, 1)) {
    model.nodes[node].velocity = {0, -20, 0};
  }
  model.contact.cords = true;
  CableSystem system(model);
  const double kinetic = system.audit().kinetic;
  advance(system, 0.02, 0.5 * system.stable_step().step);
  const EnergyAudit audit = system.audit();
  ASSERT_GT(audit.spent.total(), 0.01 * kinetic);
  expect_below("energy error / kinetic energy at the start, blow on a rod's clamped end",
               std::abs(audit.error) / kinetic, 1e-4, "work of contact at the mean velocity of each step");
}

TEST_F(VerificationCordContact, SwitchedOffTheyPass) {
  CrossingCords cords(5);
  cords.model.contact.cords = false;
  CableSystem system(cords.model);
  advance(system, 0.04, 0.5 * system.stable_step().step);
  EXPECT_EQ(system.cord_contacts().count, 0);
  expect_value("height of a cord that passes, m", system.position(cords.upper[4]).y(), 0.05 - 5 * 0.04, 1e-12,
               "free flight");
}

TEST_F(VerificationCordContact, FrictionOfARodOnTwoBars) {
  // A stiff rod of 1 kg lies across two bars that cannot move and slides along itself at first.
  CableMaterial material{.section = {.EA = 1e6, .EI = 1e4, .mass_per_length = 1, .bending_damping = 1e-3},
                         .radius = 0.01,
                         .youngs_modulus = 1e9,
                         .poisson_ratio = 0.3};
  Model model;
  const std::int32_t rod = model.add_material(material);
  for (const double x : {-0.3, 0.27}) {
    for (const std::int32_t node : add_cord(model, rod, {x, 0, -0.5}, {x, 0, 0.53}, 1)) model.fix_node(node);
  }
  for (ModelGradient& gradient : model.gradients) gradient.support = Support::fixed;
  const auto slider = add_cord(model, rod, {-0.7, 0.0201, 0}, {0.7, 0.0201, 0}, 1);
  for (const std::int32_t node : slider) model.nodes[node].velocity = {1, 0, 0};
  model.gravity = {0, -9.81, 0};
  model.contact.cords = true;
  model.contact.friction = 0.3;
  CableSystem system(model);
  advance(system, 0.05, 1e-5);
  const double start = system.velocity(slider[0]).x();
  advance(system, 0.15, 1e-5);
  expect_relative("deceleration of a rod that slides along itself on two bars, mu = 0.3, m/s^2",
                  (start - system.velocity(slider[0]).x()) / 0.1, 0.3 * 9.81, 2e-2, "mu g");
  EXPECT_NEAR(system.position(slider[0]).y(), 0.02, 1e-3);
  advance(system, 1, 1e-5);
  expect_below("creep of the rod after it has come to rest, m/s", std::abs(system.velocity(slider[0]).x()), 1e-5,
               "friction in proportion to speed below the friction velocity");
}

// Adds a net of 4 x 4 meshes of 0.25 m, one element a side, at a height, turned about y. Returns its middle knot.
std::int32_t add_net(Model& model, std::int32_t cord, double height, double angle) {
  constexpr int kMeshes = 4;
  const auto first = static_cast<std::int32_t>(model.nodes.size());
  const Vector3d u(std::cos(angle), 0.02, std::sin(angle)), v(-std::sin(angle), -0.01, std::cos(angle));
  for (int i = 0; i <= kMeshes; ++i) {
    for (int j = 0; j <= kMeshes; ++j) {
      model.add_node(Vector3d(0, height, 0) + (0.25 * i - 0.5) * u + (0.25 * j - 0.48) * v);
    }
  }
  const auto knot = [&](int i, int j) { return first + i * (kMeshes + 1) + j; };
  const auto add_thread = [&](const auto& node_at) {
    const std::int32_t thread = model.add_thread("thread");
    std::int32_t gradient = -1;
    for (int k = 0; k < kMeshes; ++k) {
      const Vector3d span = model.nodes[node_at(k + 1)].position - model.nodes[node_at(k)].position;
      if (gradient < 0) gradient = model.add_gradient(node_at(k), span.normalized());
      const std::int32_t next = model.add_gradient(node_at(k + 1), span.normalized());
      model.add_element({node_at(k), gradient, node_at(k + 1), next, span.norm(), cord, 0, thread});
      gradient = next;
    }
  };
  for (int i = 0; i <= kMeshes; ++i) {
    add_thread([&](int k) { return knot(i, k); });
    add_thread([&](int k) { return knot(k, i); });
  }
  return knot(kMeshes / 2, kMeshes / 2);
}

// Two nets, one above the other, above three rods of 0.1 m that are held at their ends.
struct NetsOverRods {
  NetsOverRods() {
    const std::int32_t cord = model.add_material(damped_cord());
    CableMaterial tube = plain_cable(3.5e5, 430, 0.08);
    tube.radius = 0.05;
    tube.youngs_modulus = 0.75e9;
    tube.poisson_ratio = 0.3;
    const std::int32_t rod = model.add_material(tube);
    for (const double z : {-0.31, 0.02, 0.33}) {
      const auto nodes = add_cord(model, rod, {-1, 0, z}, {1, 0, z}, 4);
      model.fix_node(nodes.front());
      model.fix_node(nodes.back());
    }
    lower = add_net(model, cord, 0.15, 0.1);
    upper = add_net(model, cord, 0.25, 0.5);
    model.gravity = {0, -9.81, 0};
    model.contact.cords = true;
    model.contact.friction = 0.4;
  }
  Model model;
  std::int32_t lower, upper;  // middle knots
};

TEST_F(VerificationCordContact, NetsFallOnRodsAndOnEachOther) {
  const NetsOverRods nets;
  CableSystem system(nets.model);
  const double dt = 0.8 * system.stable_step().step;
  double clearance = std::numeric_limits<double>::infinity();
  int most = 0;
  for (int frame = 1; frame <= 80; ++frame) {
    advance(system, 0.01 * frame, dt);
    clearance = std::min(clearance, least_clearance(system));
    most = std::max(most, system.cord_contacts().count);
  }
  ASSERT_FALSE(system.fault()) << *system.fault();
  ASSERT_GT(most, 15);
  expect_value("nets dropped on rods and on each other: least distance of two axes in 0.8 s, of the sum of radii",
               std::min(clearance, 1.0), 1, 0.4,
               "cords touch at 1; impacts at 2 m/s press 4 mm together by 2.7 dt v^0.8");
  // Both still lie on the rods: the middle knots are over the middle one.
  EXPECT_GT(system.position(nets.lower).y(), 0.04);
  EXPECT_GT(system.position(nets.upper).y(), 0.04);
}

// Moves the upper cord down into the lower one, which is 0.05 m below, until their axes are at `distance` (m).
void press_together(CableSystem& system, const CrossingCords& cords, double distance) {
  std::vector<Vector3d> displacements(cords.model.nodes.size(), Vector3d::Zero());
  for (const std::int32_t node : cords.upper) displacements[static_cast<std::size_t>(node)].y() = distance - 0.05;
  system.displace(displacements);
}

// Nothing has pressed the two together, so nothing drives them apart.
TEST(CordContactAccount, OverlapThatAppearsGivesNoEnergy) {
  for (const double distance : {0.0005, 0.003, 0.0035}) {  // m, of 0.004 between axes that touch
    const CrossingCords cords(0);
    CableSystem system(cords.model);
    press_together(system, cords, distance);
    for (int i = 0; i < 200; ++i) system.step(0.5 * system.stable_step().step);
    EXPECT_GT(system.safeguards().parted_overlaps, 0) << distance;
    EXPECT_EQ(system.cord_contacts().count, 0) << distance;
    EXPECT_LT(system.audit().kinetic, 1e-20) << distance;
    EXPECT_EQ(system.audit().contact, 0) << distance;
  }
}

// Springs yield where an impact is faster than 10 m/s. Steps are fine, so that the account has no error of its own.
TEST(CordContactAccount, SpringsThatYieldSpendTheirEnergy) {
  for (const double speed : {14.0, 20.0, 40.0}) {
    const CrossingCords cords(speed);
    CableSystem system(cords.model);
    const double dt = 0.03 * system.stable_step().step;
    double spent = 0;
    while (system.time() < 0.1 / speed) {
      system.step(dt);
      const EnergyAudit audit = system.audit();
      EXPECT_GE(audit.spent.in_contacts, spent * (1 - 1e-12));
      spent = audit.spent.in_contacts;
    }
    EXPECT_GT(system.safeguards().parted_overlaps, 0);
    EXPECT_LT(std::abs(system.audit().error), 0.05 * spent) << speed;
  }
}

// Nothing holds cords that are deep in each other and fly apart by themselves, and that spends nothing.
TEST(CordContactAccount, ClosesWhereDeepOverlapsPart) {
  const CrossingCords cords(-5);
  CableSystem system(cords.model);
  press_together(system, cords, 0.0005);
  const double dt = 0.5 * system.stable_step().step;
  system.step(dt);
  EXPECT_GT(system.safeguards().parted_overlaps, 0);
  const double kinetic = system.audit().kinetic;
  for (int i = 0; i < 200; ++i) system.step(dt);
  EXPECT_EQ(system.cord_contacts().count, 0);
  EXPECT_LT(std::abs(system.audit().error), 5e-3 * kinetic);
}

}  // namespace
}  // namespace netpocket
