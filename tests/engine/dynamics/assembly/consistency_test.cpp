// The two evaluations of one net against each other, as its mesh is refined.

#include <array>

#include "tests/engine/dynamics/models.h"
#include "tests/engine/verification_table.h"

namespace netpocket {
namespace {

using namespace test;

// Soft enough to swing visibly.
CableMaterial soft_cord() {
  CableMaterial cord = plain_cable(2000, 0.02, 0.1);
  cord.section.axial_damping = 1e-4;
  cord.section.bending_damping = 1e-3;
  return cord;
}

// A net of 3 x 3 threads over 1 m, held at its corners, falling under its weight.
Model hanging_net(int elements_per_side, const CableMaterial& cord = soft_cord()) {
  Model model;
  const auto material = model.add_material(cord);
  constexpr int kKnots = 3;
  for (int i = 0; i < kKnots; ++i) {
    for (int j = 0; j < kKnots; ++j) model.add_node({0.5 * i, 0, 0.5 * j});
  }
  // A thread runs through its knots with one slope at each.
  const auto add_thread = [&](std::int32_t first, std::int32_t stride) {
    const Eigen::Vector3d direction = (model.nodes[first + stride].position - model.nodes[first].position).normalized();
    std::int32_t node = first, slope = model.add_gradient(first, direction);
    const double length = 0.5 / elements_per_side;
    for (int i = 1; i <= (kKnots - 1) * elements_per_side; ++i) {
      const bool knot = i % elements_per_side == 0;
      const std::int32_t next = knot ? first + stride * (i / elements_per_side)
                                     : model.add_node(model.nodes[node].position + length * direction);
      const std::int32_t next_slope = model.add_gradient(next, direction);
      model.add_element({node, slope, next, next_slope, length, material});
      node = next;
      slope = next_slope;
    }
  };
  for (int i = 0; i < kKnots; ++i) {
    add_thread(kKnots * i, 1);
    add_thread(i, kKnots);
  }
  for (const std::int32_t corner : {0, 2, 6, 8}) model.fix_node(corner);
  model.gravity = {0, -9.81, 0};
  return model;
}

double peak_tension(CableSystem& system) {
  Snapshot snapshot;
  system.capture(snapshot);
  return snapshot.tension.maxCoeff();
}

// How far the evaluations of a model are apart over 0.5 s: root mean squares relative to the largest value.
struct Difference {
  double position, energy, tension;
};

template <typename Height>
Difference difference(const Model& model, const Height& height) {
  CableSystem mean(model), full(model, {.evaluation = ElementEvaluation::full});
  const double dt_mean = 0.7 * mean.stable_step().step, dt_full = 0.7 * full.stable_step().step;
  const double start = height(mean);
  Eigen::Vector3d square = Eigen::Vector3d::Zero(), largest = Eigen::Vector3d::Zero();
  constexpr int kFrames = 25;
  for (int i = 1; i <= kFrames; ++i) {
    advance(mean, 0.02 * i, dt_mean);
    advance(full, 0.02 * i, dt_full);
    const Eigen::Vector3d of_mean(height(mean) - start, mean.audit().strain, peak_tension(mean));
    const Eigen::Vector3d of_full(height(full) - start, full.audit().strain, peak_tension(full));
    square += (of_mean - of_full).cwiseAbs2() / kFrames;
    largest = largest.cwiseMax(of_full.cwiseAbs());
  }
  const Eigen::Vector3d relative = square.cwiseSqrt().cwiseQuotient(largest);
  return {relative[0], relative[1], relative[2]};
}

class VerificationConsistency : public VerificationTest {
 protected:
  // Meshes of 1, 2 and 4 elements a unit.
  template <typename Run>
  void expect_convergence(const std::string& what, const std::string& source, const Run& run) {
    std::array<Difference, 3> apart{};
    for (std::size_t i = 0; i < apart.size(); ++i) {
      apart[i] = run(1 << i);
      const std::string mesh = ", " + std::to_string(1 << i) + " elements a side";
      const double bound = 0.5 / std::pow(2, i);
      expect_below(what + ": position, mean-strain against full" + mesh, apart[i].position, bound, source);
      expect_below(what + ": strain energy, mean-strain against full" + mesh, apart[i].energy, 2 * bound, source);
      expect_below(what + ": largest tension, mean-strain against full" + mesh, apart[i].tension, 2 * bound, source);
    }
    expect_value(what + ": order in which the positions meet, 2 to 4 elements",
                 std::log2(apart[1].position / apart[2].position), 2, 1.2, "the mean-strain evaluation is of order 2");
  }
};

TEST_F(VerificationConsistency, EvaluationsOfANetConverge) {
  expect_convergence("falling net", "net of 3 x 3 threads falling for 0.5 s: rms difference / largest value",
                     [](int per_side) {
                       return difference(hanging_net(per_side), [](const CableSystem& s) { return s.position(4).y(); });
                     });
}

TEST_F(VerificationConsistency, EvaluationsOfARodConverge) {
  expect_convergence(
      "falling rod", "clamped rod of 2 m falling for 0.5 s: rms difference / largest value", [](int per_side) {
        CableMaterial rod = plain_cable(2e4, 2, 0.4);
        rod.section.axial_damping = 1e-4;
        rod.section.bending_damping = 1e-3;
        Cable cable = straight_cable(rod, {0, 0, 0}, {2, 0, 0}, 3 * per_side);
        cable.model.fix_node(cable.nodes.front());
        cable.model.fix_gradient(cable.gradients.front());
        cable.model.gravity = {0, -9.81, 0};
        return difference(cable.model,
                          [tip = cable.nodes.back()](const CableSystem& s) { return s.position(tip).y(); });
      });
}

TEST_F(VerificationConsistency, StepOfASlackCordIsThatOfATautOne) {
  // A tension-only cord that is slack at the start has no axial stiffness then, but will have it.
  CableMaterial cord = net_cord();
  cord.section.compression = 0;
  for (const ElementEvaluation evaluation : {ElementEvaluation::mean_strain, ElementEvaluation::full}) {
    const auto step = [&](double stretch) {
      Model model = straight_cable(cord, {0, 0, 0}, {1, 0, 0}, 4).model;
      for (ModelNode& node : model.nodes) node.position *= stretch;
      for (ModelGradient& gradient : model.gradients) gradient.value *= stretch;
      return CableSystem(model, {.evaluation = evaluation}).stable_step().step;
    };
    EXPECT_NEAR(step(0.999) / step(1.001), 1, 0.02);
  }
}

TEST_F(VerificationConsistency, SlackTensionOnlyNetComesToRest) {
  // The paper's net cord without any stiffness in compression, its corners 15 % nearer than the threads are long.
  CableMaterial cord = net_cord();
  cord.section.axial_damping = 1e-5;
  cord.section.bending_damping = 1e-2;
  cord.section.compression = 0;
  Model model = hanging_net(2, cord);
  for (ModelNode& node : model.nodes) node.position *= 0.85;
  for (ModelGradient& gradient : model.gradients) gradient.value *= 0.85;
  const double weight = 9.81 * model.cable_mass();
  for (const auto& [evaluation, name] :
       {std::pair{ElementEvaluation::mean_strain, "mean-strain"}, {ElementEvaluation::full, "full"}}) {
    CableSystem system(model, {.evaluation = evaluation});
    advance(system, 0.2, 0.8 * system.stable_step().step);
    ASSERT_GT(system.audit().kinetic, 1e-4 * weight) << "it does not fall";
    advance(system, 10, 0.8 * system.stable_step().step);
    ASSERT_FALSE(system.fault()) << *system.fault();
    const EnergyAudit audit = system.audit();
    const std::string source = "net cord, compression 0, corners 15 % nearer than the threads are long, under gravity";
    expect_below(std::string("slack tension-only net after 10 s: energy error / (weight x 1 m), ") + name,
                 std::abs(audit.error) / weight, 1e-4, source);
    expect_below(std::string("slack tension-only net after 10 s: kinetic energy / (weight x 1 m), ") + name,
                 audit.kinetic / weight, 1e-3, "it comes to rest");
    double shortest = 1;
    for (std::int32_t i = 0; i < static_cast<std::int32_t>(model.gradients.size()); ++i) {
      shortest = std::min(shortest, system.gradient(i).norm());
    }
    expect_below(std::string("slack tension-only net after 10 s: 1 - least length of r', ") + name, 1 - shortest, 0.25,
                 "15 % of slack stays spread along the threads: it does not gather at a point");
  }
}

}  // namespace
}  // namespace netpocket
