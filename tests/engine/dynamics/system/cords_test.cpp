// Cords and nets of the whole system against closed forms, both evaluations.

#include <array>

#include "tests/engine/dynamics/models.h"
#include "tests/engine/verification_table.h"

namespace netpocket {
namespace {

using namespace test;

class VerificationCords : public VerificationTest {};

constexpr std::array<std::pair<ElementEvaluation, const char*>, 2> kEvaluations = {
    {{ElementEvaluation::mean_strain, "mean-strain"}, {ElementEvaluation::full, "full"}}};

TEST_F(VerificationCords, AxialWaveSpeed) {
  // A cord that flies away from its fixed end: the front that stops it runs along it at c. A point at x stands still
  // after x/c, by when it has moved v x/c.
  const CableMaterial cord = net_cord();
  const double length = 5, speed = 0.05;
  const double wave_speed = std::sqrt(cord.section.EA / cord.section.mass_per_length);
  for (const auto& [evaluation, name] : kEvaluations) {
    Cable cable = straight_cable(cord, {0, 0, 0}, {length, 0, 0}, 100);
    cable.model.fix_node(cable.nodes.front());
    for (std::size_t i = 1; i < cable.nodes.size(); ++i) {
      cable.model.nodes[cable.nodes[i]].velocity = {speed, 0, 0};
    }
    CableSystem system(cable.model, {.evaluation = evaluation});
    // Averaged between the front's passage and its return, so that the ringing behind it does not count.
    const double dt = 0.5 * system.stable_step().step, place = 0.6 * length;
    double sum = 0;
    int count = 0;
    while (system.time() < 1.3 * length / wave_speed) {
      system.step(dt);
      if (system.time() < 0.8 * length / wave_speed) continue;
      sum += system.position(cable.nodes[60]).x() - place;
      ++count;
    }
    expect_relative(std::string("speed of an axial wave in the net cord, m/s, 100 elements, ") + name,
                    speed * place / (sum / count), wave_speed, 5e-3, "sqrt(E/rho); the front is as wide as an element");
  }
}

// A square net of cords under tension, four meshes a side, held at its edge, a load P at each knot across it.
Model loaded_net(double stretch, double load, int per_side) {
  constexpr int kMeshes = 4, kKnots = kMeshes + 1;
  Model model;
  const auto cord = model.add_material(plain_cable(1e4, 1e-4, 0.05));
  for (int i = 0; i < kKnots; ++i) {
    for (int j = 0; j < kKnots; ++j) model.add_node({0.5 * i, 0, 0.5 * j});
  }
  const auto inner = [](int i) { return i > 0 && i < kMeshes; };
  for (int i = 0; i < kKnots; ++i) {
    for (int j = 0; j < kKnots; ++j) {
      const std::int32_t knot = kKnots * i + j;
      if (inner(i) && inner(j)) {
        model.nodes[knot].load = {0, load, 0};
      } else {
        model.fix_node(knot);
      }
    }
  }
  const auto add_thread = [&](std::int32_t first, std::int32_t stride, const Eigen::Vector3d& direction) {
    std::int32_t node = first, slope = model.add_gradient(first, (1 + stretch) * direction);
    for (int i = 1; i <= kMeshes * per_side; ++i) {
      const std::int32_t next = i % per_side == 0
                                    ? first + stride * (i / per_side)
                                    : model.add_node(model.nodes[node].position + 0.5 / per_side * direction);
      const std::int32_t next_slope = model.add_gradient(next, (1 + stretch) * direction);
      model.add_element({node, slope, next, next_slope, 0.5 / per_side / (1 + stretch), cord});
      node = next;
      slope = next_slope;
    }
  };
  for (int i = 1; i < kMeshes; ++i) {
    add_thread(kKnots * i, 1, Eigen::Vector3d::UnitZ());
    add_thread(i, kKnots, Eigen::Vector3d::UnitX());
  }
  return model;
}

TEST_F(VerificationCords, TensionedNetUnderLoad) {
  // Small deflections w of knots with spacing a and tension T: T (4 w - sum of neighbours) / a = P. For three by three
  // knots the solution is w = 9/8, 7/8 and 11/16 of P a/T at the centre, the sides and the corners.
  const double stretch = 0.01, load = 0.02, spacing = 0.5;
  const double tension = 1e4 * (stretch + stretch * stretch / 2) * (1 + stretch);  // EA eps |r'|
  for (const auto& [evaluation, name] : kEvaluations) {
    const Model model = loaded_net(stretch, load, 4);
    const CableSystem system = relax(model, {.evaluation = evaluation}, 1e-14);
    const std::string what = std::string(" knot of a tensioned net, m, ") + name;
    const std::string source =
        "discrete membrane, T (4 w - sum of neighbours)/a = P; slopes go on through knots, so a kink is as wide as "
        "an element: first order in its length, 4 a side";
    const double unit = load * spacing / tension;
    expect_relative("deflection of the centre" + what, system.position(12).y(), unit * 9 / 8, 2e-2, source);
    expect_relative("deflection of a side" + what, system.position(7).y(), unit * 7 / 8, 2e-2, source);
    expect_relative("deflection of a corner" + what, system.position(6).y(), unit * 11 / 16, 2e-2, source);
  }
}

TEST_F(VerificationCords, ElasticaOutOfThePlanesOfTheAxes) {
  // Bisshopp & Drucker's cantilever, P L^2/EI = 2, along and loaded in slanting directions, by relaxation.
  const Eigen::Vector3d along = Eigen::Vector3d(2, -1, 2) / 3, across = Eigen::Vector3d(1, 2, 0) / std::sqrt(5);
  for (const auto& [evaluation, name] : kEvaluations) {
    const bool full = evaluation == ElementEvaluation::full;
    CableMaterial rod = plain_cable(2e4, 1, 0.1);
    rod.section.bending_damping = 1e-3;
    Cable cable = straight_cable(rod, {0, 0, 0}, along, 16);
    Model& model = cable.model;
    model.fix_node(cable.nodes.front());
    model.fix_gradient(cable.gradients.front());
    model.nodes[cable.nodes.back()].load = 2 * across;
    const CableSystem system = relax(model, {.evaluation = evaluation}, 1e-10);
    const Eigen::Vector3d tip = system.position(cable.nodes.back());
    const std::string source =
        "Bisshopp & Drucker (1945), P L^2/EI = 2, in slanting directions; 16 elements, EA L^2/EI "
        "= 2e4: stretch and locking below 1e-3";
    expect_relative(std::string("elastica in space: deflection / L, ") + name, tip.dot(across), .49345748,
                    full ? 3e-3 : 2e-3, source);
    expect_relative(std::string("elastica in space: shortening / L, ") + name, 1 - tip.dot(along), .16064172, 5e-3,
                    source);
    expect_below(std::string("elastica in space: off the plane of the load, m, ") + name,
                 std::abs(tip.dot(along.cross(across))), 1e-6,
                 "no torsion, no force across: what the relaxation leaves");
  }
}

}  // namespace
}  // namespace netpocket
