// The two evaluations of one net against each other, as its mesh is refined.

#include "tests/engine/dynamics/models.h"
#include "tests/engine/verification_table.h"

namespace netpocket {
namespace {

using namespace test;

// A net of 3 x 3 threads over 1 m, held at its corners, falling under its weight: soft enough to swing visibly.
Model hanging_net(int elements_per_side) {
  Model model;
  CableMaterial cord = plain_cable(2000, 0.02, 0.1);
  cord.section.axial_damping = 1e-4;
  cord.section.bending_damping = 1e-3;
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

// Root mean square of the middle knot's height differences over 0.5 s, of its largest fall.
double difference(int elements_per_side) {
  const Model model = hanging_net(elements_per_side);
  CableSystem mean(model), full(model, {.evaluation = ElementEvaluation::full});
  const double dt_mean = 0.7 * mean.stable_step().step, dt_full = 0.7 * full.stable_step().step;
  double square = 0, deepest = 0;
  constexpr int kFrames = 25;
  for (int i = 1; i <= kFrames; ++i) {
    advance(mean, 0.02 * i, dt_mean);
    advance(full, 0.02 * i, dt_full);
    square += std::pow(mean.position(4).y() - full.position(4).y(), 2) / kFrames;
    deepest = std::max(deepest, -full.position(4).y());
  }
  return std::sqrt(square) / deepest;
}

class VerificationConsistency : public VerificationTest {};

TEST_F(VerificationConsistency, EvaluationsOfANetConverge) {
  const double coarse = difference(1), medium = difference(2), fine = difference(4);
  const std::string source = "net of 3 x 3 threads falling for 0.5 s: rms difference of the middle knot / deepest fall";
  expect_below("mean-strain against full, 1 element a side", coarse, 0.5, source);
  expect_below("mean-strain against full, 2 elements a side", medium, 0.2, source);
  expect_below("mean-strain against full, 4 elements a side", fine, 0.05, source);
  EXPECT_LT(medium, coarse);
  EXPECT_LT(fine, 0.6 * medium);
}

}  // namespace
}  // namespace netpocket
