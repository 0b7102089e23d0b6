// V7: all of a cord touches: edges, thin bodies, from rest, between nodes, at speed. Against statics by hand.

#include <fmt/format.h>

#include <functional>
#include <numbers>

#include "tests/engine/dynamics/models.h"
#include "tests/engine/verification_table.h"

namespace netpocket {
namespace {

using namespace test;
using Eigen::Vector3d;

class VerificationWholeCord : public VerificationTest {};

// A body that its control keeps where it is, or moves.
ModelBody anvil(const Shape& shape, const Vector3d& position,
                const Eigen::Quaterniond& attitude = Eigen::Quaterniond::Identity()) {
  ModelBody body{
      .name = "anvil", .shape = shape, .mass = 1e6, .inertia = 1e6 * Eigen::Matrix3d::Identity(), .state = {}};
  body.state.position = position;
  body.state.attitude = attitude;
  return body;
}

void move_anvil(CableSystem& system, const Vector3d& velocity) {
  system.control(0, {.velocity = {velocity.x(), velocity.y(), velocity.z()}, .hold_attitude = true});
}

bool touches(CableSystem& system) {
  Snapshot snapshot;
  system.capture(snapshot);
  return !snapshot.contacts.empty();
}

TEST_F(VerificationWholeCord, FromRest) {
  Cable cable = straight_cable(net_cord(), {-1, 0.003, 0}, {1, 0.003, 0}, 4);
  cable.model.add_body(anvil(Box{{4, 4, 4}}, {0, -2, 0}));
  // On the nodes alone: weight would turn the slopes of the free ends, too.
  for (std::size_t i = 0; i < cable.nodes.size(); ++i) {
    const double length = i == 0 || i + 1 == cable.nodes.size() ? 0.25 : 0.5;
    cable.model.nodes[cable.nodes[i]].load = {0, -500 * length * net_cord().section.mass_per_length, 0};
  }
  CableSystem system(cable.model);
  move_anvil(system, Vector3d::Zero());
  const double dt = 1e-5;
  while (system.time() < 0.01 && !touches(system)) system.step(dt);
  expect_relative("contact of a cord at rest 1 mm above a box, 500 m/s^2, s", system.time(), 2e-3, 1e-2,
                  "sqrt(2 h/a), found at most two steps late (verification case V7)");
  advance(system, 0.05, dt);
  expect_below("and its deepest penetration, m", system.take_deepest_contacts().penetration, 5e-3,
               "the impact of 1 m/s and the load's own depth; it was 0.69 m");
}

TEST_F(VerificationWholeCord, BetweenFixedNodes) {
  CableMaterial cord = net_cord();
  cord.section.EI = 0;
  Cable cable = straight_cable(cord, {-0.5, 0, 0}, {0.5, 0, 0}, 1);
  for (const std::int32_t node : cable.nodes) cable.model.fix_node(node);
  cable.model.gradients[0].rate = {0, 5, 0};
  cable.model.gradients[1].rate = {0, -5, 0};
  cable.model.add_body(anvil(Sphere{1}, {0, 1.007, 0}));
  CableSystem system(cable.model);
  const double dt = 1e-4;
  while (system.time() < 0.02 && !touches(system)) system.step(dt);
  expect_relative(
      "contact of an element whose slopes turn at 5 1/s between fixed nodes, s", system.time(), 4e-3, 5e-2,
      "5 mm at 1.25 m/s, which stretching slows a little (verification case V7); found two steps late at most");
  EXPECT_LT(system.penetration(), 1.25 * 2 * dt);
}

// A taut cord that falls on a bar of 2 cm, wherever that lies along an element.
TEST_F(VerificationWholeCord, BarBetweenPoints) {
  double least = 1e9, largest = 0;
  for (double offset = 0; offset <= 0.5; offset += 0.03125) {
    CableMaterial cord = net_cord();
    cord.section.axial_damping = 1e-5;
    Cable cable = straight_cable(cord, {-2, 0.02, 0}, {2, 0.02, 0}, 8);
    for (ModelNode& node : cable.model.nodes) node.velocity = {0, -1, 0};
    cable.model.add_body(anvil(Box{{0.02, 0.02, 1}}, {offset, 0, 0}));
    CableSystem system(cable.model);
    move_anvil(system, Vector3d::Zero());
    advance(system, 0.03, 0.8 * system.stable_step().step);
    const double impulse = -system.contact_impulse(0).y();
    least = std::min(least, impulse);
    largest = std::max(largest, impulse);
    EXPECT_LT(system.take_deepest_contacts().penetration, 0.004) << offset;
  }
  ASSERT_GT(least, 0.005);
  expect_below("impulse of a cord that falls on a bar of 2 cm: largest / least over its places in an element",
               largest / least, 1.6, "mass of a node, of an element's middle; it was nothing between two samples");
}

struct Hold {
  const char* name;
  Shape shape;
  Eigen::Quaterniond attitude;
  double top;  // m, of the body's centre below the highest point
};

std::vector<Hold> holds() {
  const Eigen::Quaterniond turned(Eigen::AngleAxisd(std::numbers::pi / 4, Vector3d::UnitZ()));
  const Eigen::Quaterniond lying(Eigen::AngleAxisd(std::numbers::pi / 2, Vector3d::UnitX()));
  const Eigen::Quaterniond straight = Eigen::Quaterniond::Identity();
  return {{"an edge of a box", Box{{1, 1, 1}}, turned, 0.5 * std::numbers::sqrt2},
          {"a sphere of 0.3 m", Sphere{0.3}, straight, 0.3},
          {"a cylinder of 0.2 m", Cylinder{0.2, 1}, lying, 0.2},
          {"a panel of 2 cm", Box{{0.02, 1, 1}}, straight, 0.5}};
}

// A cord of 4 m under tension between two fixed points, held up in its middle by 0.25 m: 14 degrees on each side.
struct HeldCord {
  HeldCord(const Hold& hold, int elements_per_metre, double place, double radius = net_cord().radius,
           double edge_radius = 0) {
    constexpr double kTension = 60, kRise = 0.25;
    CableMaterial cord = net_cord();
    cord.radius = radius;
    cord.section.EA = 2e4;  // stretches by 1 %: its tension is of its length, not of its bends
    cord.section.EI = 1e-3;
    cord.section.axial_damping = 2e-5;
    cord.section.bending_damping = 1e-3;
    const double stretched = 1 + kTension / cord.section.EA;
    cable = straight_cable(cord, {-2, 0, 0}, {2, 0, 0}, 4 * elements_per_metre);
    Model& model = cable.model;
    for (ModelElement& element : model.elements) element.length /= stretched;
    for (ModelGradient& gradient : model.gradients) gradient.value *= stretched;
    model.fix_node(cable.nodes.front());
    model.fix_node(cable.nodes.back());
    model.add_body(anvil(hold.shape, {place, -hold.top - 0.002, 0}, hold.attitude));
    model.contact.friction = 0;
    model.contact.edge_radius = edge_radius;
    system = std::make_unique<CableSystem>(model);
    step = kStep;
    // Rises gently, which excites little, then stands.
    constexpr double kRiseTime = 2;
    while (system->time() < kRiseTime) {
      const double phase = 2 * std::numbers::pi * system->time() / kRiseTime;
      move_anvil(*system, {0, kRise / kRiseTime * (1 - std::cos(phase)), 0});
      system->step(step);
    }
    move_anvil(*system, Vector3d::Zero());
    advance(*system, kRiseTime + 0.2, step);
  }
  static constexpr double kStep = 4e-5;  // s, of the finest cord, for all: contacts are then alike

  // Mean force on the body over a time (s), N.
  double mean_force(double time) {
    const double before = system->contact_impulse(0).y(), start = system->time();
    advance(*system, start + time, step);
    return -(system->contact_impulse(0).y() - before) / (system->time() - start);
  }
  // The ends pull in the directions of their supports.
  double expected_force() {
    Snapshot snapshot;
    system->capture(snapshot);
    const auto pull = [&](std::size_t end, std::size_t inner) {
      const Vector3d along = snapshot.positions.col(cable.nodes[inner]) - snapshot.positions.col(cable.nodes[end]);
      const auto element = static_cast<Eigen::Index>(end == 0 ? cable.elements.front() : cable.elements.back());
      // The force of Green's strain is N dr/dp.
      return snapshot.tension[element] * along.y() / cable.model.elements[0].length;
    };
    return pull(0, 1) + pull(cable.nodes.size() - 1, cable.nodes.size() - 2);
  }
  Cable cable;
  std::unique_ptr<CableSystem> system;
  double step = 0;
};

// Wherever the body meets an element, and however finely the cord is divided.
TEST_F(VerificationWholeCord, TautCordOverEdgesAndRounds) {
  for (const Hold& hold : holds()) {
    for (const int fineness : {1, 2, 4}) {
      double worst = 0;
      for (const double place : {0.0, 0.2, 0.37}) {
        HeldCord cord(hold, fineness, place);
        const double force = cord.mean_force(0.2);
        ASSERT_GT(force, 40);
        worst = std::max(worst, std::abs(force / cord.expected_force() - 1));
      }
      expect_below(
          fmt::format("taut cord over {}, {} elements a metre: force against its ends' pull, relative", hold.name,
                      fineness),
          worst, 0.02,
          "equilibrium: N = 2 T sin(angle/2) by the directions of its ends, which one element of a metre bends");
    }
  }
}

// A cord whose axis is pressed into the body, beside a round edge.
TEST_F(VerificationWholeCord, RoundEdgeBearsADeepCord) {
  const double radius = 3e-5, edge_radius = 5e-3;
  HeldCord cord(holds().front(), 2, 0.2, radius, edge_radius);
  const double force = cord.mean_force(0.2);
  ASSERT_GT(force, 40);
  EXPECT_GT(cord.system->take_deepest_contacts().penetration, 2 * radius);
  expect_below("taut cord over a round edge, deeper than its radius: force against its ends' pull, relative",
               std::abs(force / cord.expected_force() - 1), 0.01, "equilibrium: N = 2 T sin(angle/2)");
  // The edge is lower than the sharp one by (sqrt(2) - 1) of its radius. With the tension T0 + EA (rise/2 m)^2/2 the
  // force grows with the power 1 + 2 (T - T0)/T = 2.44 of the rise.
  HeldCord sharp(holds().front(), 2, 0.2, radius);
  const double less = 2.44 * (std::numbers::sqrt2 - 1) * edge_radius / 0.25;
  EXPECT_NEAR(1 - force / sharp.mean_force(0.2), less, 0.1 * less);
}

// The body moves along the cord by more than an element: past a middle and a node.
TEST_F(VerificationWholeCord, SlidesSmoothly) {
  for (const Hold& hold : holds()) {
    HeldCord cord(hold, 2, -0.3);
    constexpr double kSpeed = 0.1, kWindow = 0.1;  // m/s, s: more than a period of the cord's vibration
    move_anvil(*cord.system, {kSpeed, 0, 0});
    double roughness = 0, last = cord.mean_force(kWindow);
    for (int i = 0; i < 60; ++i) {
      const double force = cord.mean_force(kWindow);
      roughness = std::max(roughness, std::abs(force / last - 1));
      last = force;
    }
    expect_below(fmt::format("force of a taut cord along which {} moves: change in 1 cm, relative", hold.name),
                 roughness, 0.02,
                 "smooth along elements and over nodes: the way changes the force by 0.3 % a centimetre");
  }
}

TEST_F(VerificationWholeCord, Capstan) {
  const double friction = 0.2;
  CableMaterial cord = net_cord();
  cord.section.EA = 2e4;
  cord.section.EI = 1e-3;
  cord.section.axial_damping = 1e-3;
  cord.section.bending_damping = 5e-2;
  const double radius = 0.5, axis = radius + 0.002, leg = 1.0, stretched = 1.02;
  const int arc = 16, straight = 4;
  Cable cable;
  Model& model = cable.model;
  const std::int32_t material = model.add_material(cord);
  // Up one leg, half round the drum, down the other.
  std::vector<Vector3d> points, directions;
  for (int i = 0; i < straight; ++i) {
    points.emplace_back(-axis, -leg * (1 - static_cast<double>(i) / straight), 0);
    directions.push_back(Vector3d::UnitY());
  }
  for (int i = 0; i <= arc; ++i) {
    const double angle = std::numbers::pi * i / arc;
    points.emplace_back(-axis * std::cos(angle), axis * std::sin(angle), 0);
    directions.emplace_back(std::sin(angle), std::cos(angle), 0);
  }
  for (int i = 1; i <= straight; ++i) {
    points.emplace_back(axis, -leg * i / straight, 0);
    directions.push_back(-Vector3d::UnitY());
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    cable.nodes.push_back(model.add_node(points[i]));
    cable.gradients.push_back(model.add_gradient(cable.nodes.back(), stretched * directions[i]));
  }
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const bool is_arc = i >= static_cast<std::size_t>(straight) && i < static_cast<std::size_t>(straight + arc);
    const double length = is_arc ? std::numbers::pi * axis / arc : leg / straight;
    model.add_element({.node1 = cable.nodes[i],
                       .gradient1 = cable.gradients[i],
                       .node2 = cable.nodes[i + 1],
                       .gradient2 = cable.gradients[i + 1],
                       .length = length / stretched,
                       .material = material});
  }
  model.fix_node(cable.nodes.front());
  model.fix_node(cable.nodes.back());
  const Eigen::Quaterniond lying(Eigen::AngleAxisd(std::numbers::pi / 2, Vector3d::UnitX()));
  model.add_body(anvil(Cylinder{radius, 1}, Vector3d::Zero(), lying));
  model.bodies[0].state.angular_velocity = {0, 0, -1};
  model.contact.friction = friction;
  CableSystem system(model);
  system.control(0, {.velocity = {0.0, 0.0, 0.0}});
  advance(system, 1.5, 0.8 * system.stable_step().step);
  Snapshot snapshot;
  system.capture(snapshot);
  expect_relative("tension ratio of a cord half round a drum that turns, mu = 0.2",
                  snapshot.tension[0] / snapshot.tension[snapshot.tension.size() - 1],
                  std::exp(friction * std::numbers::pi), 2e-2, "capstan equation T2/T1 = exp(mu theta) = 1.874456");
}

TEST_F(VerificationWholeCord, NothingTunnelsThroughAPanel) {
  for (const double speed : {1.0, 10.0, 50.0, 100.0, 300.0, 1000.0, 3000.0, 9000.0, 30000.0, 90000.0}) {
    int through = 0, hits = 0;
    for (double place = 0; place < 0.5; place += 0.02) {
      CableMaterial cord = net_cord();
      cord.section.axial_damping = 1e-5;
      Cable cable = straight_cable(cord, {-1, 0.5 + 0.37 * place, 0.1}, {1, 0.5 + 0.37 * place, 0.1}, 4);
      for (ModelNode& node : cable.model.nodes) node.velocity = {0, -speed, 0};
      cable.model.add_body(anvil(Box{{6, 0.02, 6}}, {place, 0, 0}));
      CableSystem system(cable.model);
      move_anvil(system, Vector3d::Zero());
      // Bends of cords that a blow has stretched are stiffer: steps follow, as in a run.
      const StableStep straight = system.stable_step();
      const double end = 30 * straight.step + 2 / speed;
      while (system.time() < end && !system.fault()) system.step(0.8 * system.stable_step_as_bent(straight));
      ++hits;
      for (const std::int32_t node : cable.nodes) {
        if (system.position(node).y() < -0.01) {
          ++through;
          break;
        }
      }
    }
    expect_below(fmt::format("cords through a panel of 2 cm at {} m/s, of {}", speed, hits), through, 0,
                 "nothing tunnels (verification case V7)");
  }
}

// Cords between fixed ends, each with a sphere that rises into it. Elements are listed by `order`(place along the cord,
// cord), so that those which continue each other are in any lanes of any blocks.
template <typename Order>
std::vector<Vector3d> impulses_of_rising_spheres(int cords, const Order& order) {
  constexpr int elements = 16;
  Model model;
  const std::int32_t material = model.add_material(net_cord());
  std::vector<ModelElement> listed(static_cast<std::size_t>(cords * elements));
  for (int cord = 0; cord < cords; ++cord) {
    const double z = 16 * cord;  // a power of two: adding it rounds nothing that matters
    const auto first = model.add_node({-2, 0.01, z}), last = model.add_node({2, 0.01, z});
    const auto along = model.add_straight_cable(first, last, elements, material);
    model.fix_node(first);
    model.fix_node(last);
    for (int i = 0; i < elements; ++i) {
      listed[static_cast<std::size_t>(order(i, cord))] =
          model.elements[static_cast<std::size_t>(along[static_cast<std::size_t>(i)])];
    }
    model.add_body(anvil(Sphere{3}, {0.03, -3, z}));
  }
  model.elements = listed;
  CableSystem system(model);
  for (int cord = 0; cord < cords; ++cord) system.control(cord, {.velocity = {0.0, 0.5, 0.0}, .hold_attitude = true});
  advance(system, 0.3, 0.8 * system.stable_step().step);
  std::vector<Vector3d> impulses;
  for (int cord = 0; cord < cords; ++cord) impulses.push_back(system.contact_impulse(cord));
  return impulses;
}

TEST_F(VerificationWholeCord, OrderOfElementsDoesNotMatterOnASphere) {
  const auto difference = [](const std::vector<Vector3d>& impulses, const Vector3d& expected) {
    double largest = 0;
    for (const Vector3d& impulse : impulses) largest = std::max(largest, (impulse - expected).norm() / expected.norm());
    return largest;
  };
  const auto alone = [](const std::function<int(int)>& order) {
    return impulses_of_rising_spheres(1, [&](int i, int) { return order(i); });
  };
  const Vector3d along = alone([](int i) { return i; }).front();
  EXPECT_GT(std::abs(along.y()), 1);
  const std::string reason = "the same forces in another order: round-off";
  expect_below("impulse on a sphere: elements listed backwards, relative",
               difference(alone([](int i) { return 15 - i; }), along), 1e-9, reason);
  expect_below("and every fifth one, around", difference(alone([](int i) { return 5 * i % 16; }), along), 1e-9, reason);
  expect_below("and eight cords side by side in the lanes",
               difference(impulses_of_rising_spheres(8, [](int i, int cord) { return 8 * i + cord; }), along), 1e-9,
               reason);
  expect_below("and five cords one after the other",
               difference(impulses_of_rising_spheres(5, [](int i, int cord) { return 5 * i + cord; }), along), 1e-9,
               reason);
}

}  // namespace
}  // namespace netpocket
