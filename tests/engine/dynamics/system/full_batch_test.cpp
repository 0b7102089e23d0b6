// The vectorised full element and the factored mass against their readable forms.

#include "engine/ancf/full_batch.h"

#include <Eigen/Cholesky>
#include <array>
#include <random>

#include "engine/ancf/full_element.h"
#include "engine/ancf/mass.h"
#include "engine/dynamics/assembly/consistent_mass.h"
#include "engine/math/instruction_set.h"
#include "tests/engine/dynamics/models.h"
#include "tests/engine/verification_table.h"

namespace netpocket {
namespace {

using namespace test;

// Elements at random between coordinates in a random state. Coordinates' gradients are of any size, so that the
// curvature below the smallest stretch is tried too.
struct RandomElements {
  static constexpr std::int32_t kElementCoordinates = 48;

  explicit RandomElements(double compression, bool variable)
      : coordinates(kElementCoordinates), velocities(kElementCoordinates) {
    for (std::int32_t i = 0; i < kElementCoordinates; ++i) {
      coordinates.set(i, {uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)});
      velocities.set(i, {uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)});
    }
    for (int i = 0; i < 61; ++i) {
      BatchElement element{.coordinate = {},
                           .length = uniform(0.1, 2),
                           .section = {.EA = uniform(10, 1000),
                                       .EI = uniform(0.1, 10),
                                       .mass_per_length = 1,
                                       .axial_damping = uniform(0, 0.1),
                                       .bending_damping = uniform(0, 0.1),
                                       .compression = compression},
                           .variable = variable && i % 3 == 0};
      for (std::int32_t& coordinate : element.coordinate)
        coordinate = static_cast<std::int32_t>(generator() % kElementCoordinates);
      elements.push_back(element);
      const double rate = element.variable ? 1 : 0;
      spans.push_back(
          {.length = element.length, .start_rate = rate * uniform(-1, 1), .end_rate = rate * uniform(-1, 1)});
    }
  }

  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(generator); }
  ElementCoordinates gather(const CoordinateVectors& vectors, std::size_t i) const {
    ElementCoordinates q;
    for (int corner = 0; corner < 4; ++corner) q.col(corner) = vectors.get(elements[i].coordinate[corner]);
    return q;
  }

  std::mt19937 generator{11};
  std::vector<BatchElement> elements;
  std::vector<MaterialSpan> spans;
  CoordinateVectors coordinates, velocities;
};

// Largest difference of force or power, relative to the largest.
double difference_to_reference(RandomElements& state) {
  ElementBatch batch(state.elements);
  FullBatch full(batch.block_count());
  for (std::size_t i = 0; i < state.elements.size(); ++i) {
    if (!state.elements[i].variable) continue;
    const auto element = static_cast<int>(i);
    batch.set_length(element, state.spans[i].length, state.spans[i].length_rate());
    full.set_start_rate(element, state.spans[i].start_rate);
  }
  AlignedVector<double> rows(static_cast<std::size_t>(batch.block_count()) * kForceRows * kBlockSize, -1.0);
  const BatchPower power =
      full.forces(batch, 0, batch.block_count(), state.coordinates.rows(), state.velocities.rows(), rows.data());
  double largest = 0, difference = 0, dissipated = 0, fed = 0;
  for (std::size_t i = 0; i < state.elements.size(); ++i) {
    const FullElement element(state.elements[i].section, state.spans[i]);
    const ElementCoordinates q = state.gather(state.coordinates, i), velocity = state.gather(state.velocities, i);
    const ElementCoordinates force = element.internal_force(q, velocity);
    dissipated += element.dissipated_power(q, velocity);
    fed += element.feeding_power(q, velocity);
    largest = std::max(largest, force.cwiseAbs().maxCoeff());
    const double* row = rows.data() + i / kBlockSize * kForceRows * kBlockSize + i % kBlockSize;
    const int columns[3] = {0, 1, 3};
    for (int part = 0; part < 9; ++part) {
      difference = std::max(difference, std::abs(row[part * kBlockSize] - force(part % 3, columns[part / 3])));
    }
  }
  const double scale = std::max(dissipated, std::abs(fed));
  return std::max(
      {difference / largest, std::abs(power.dissipated - dissipated) / scale, std::abs(power.fed - fed) / scale});
}

class VerificationFullBatch : public VerificationTest {};

TEST_F(VerificationFullBatch, EqualsTheReferenceElement) {
  for (const double compression : {1.0, 0.0}) {
    for (const bool variable : {false, true}) {
      RandomElements state(compression, variable);
      expect_below(std::string("relative difference of forces and power, ") + (variable ? "variable" : "constant") +
                       " length, compression " + std::to_string(compression).substr(0, 1),
                   difference_to_reference(state), 1e-13,
                   "full_element.h; sums of some 500 terms of unit round-off 1.1e-16, random states with slopes of any "
                   "size");
    }
  }
}

TEST_F(VerificationFullBatch, InstructionSetsGiveTheSameBits) {
  for (const bool variable : {false, true}) {
    RandomElements state(0.5, variable);
    ElementBatch batch(state.elements);
    for (std::size_t i = 0; i < state.elements.size(); ++i) {
      if (state.elements[i].variable) {
        batch.set_length(static_cast<int>(i), state.spans[i].length, state.spans[i].length_rate());
      }
    }
    std::vector<full_kernel::StartRates> rates(batch.block_count());
    const auto run = [&](full_kernel::Kernel kernel) {
      AlignedVector<double> rows(static_cast<std::size_t>(batch.block_count()) * kForceRows * kBlockSize);
      const BatchPower power = kernel(batch.view(), rates.data(), 0, batch.block_count(), state.coordinates.rows(),
                                      state.velocities.rows(), rows.data());
      rows.insert(rows.end(), {power.dissipated, power.fed});
      return rows;
    };
    const auto baseline = run(full_kernel::baseline::element_forces);
    if (has(InstructionSet::avx2)) {
      EXPECT_EQ(run(full_kernel::avx2::element_forces), baseline);
    }
    if (has(InstructionSet::avx512)) {
      EXPECT_EQ(run(full_kernel::avx512::element_forces), baseline);
    }
  }
}

TEST_F(VerificationFullBatch, FactoredMassEqualsADenseSolve) {
  // A cord with a rope at its end, whose masses change; the first node is fixed.
  Cable cable = straight_cable(net_cord(), {0, 0, 0}, {3, 0, 0}, 6);
  Model& model = cable.model;
  model.fix_node(cable.nodes.front());
  const auto far = model.add_node({5, 0, 0});
  const auto rope = model.add_straight_cable(cable.nodes.back(), far, 2, 0);
  model.ropes.push_back({rope, {2}});
  const CoordinateLayout layout{static_cast<std::int32_t>(model.nodes.size()),
                                static_cast<std::int32_t>(model.gradients.size())};
  const double m = model.materials[0].section.mass_per_length;

  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(layout.size(), layout.size());
  std::vector<double> lumped(layout.size(), 0.0), present;
  const std::vector<std::uint8_t> is_lumped = lumped_elements(model);
  std::vector<std::int32_t> changing;
  for (std::size_t i = 0; i < model.elements.size(); ++i) {
    const ModelElement& e = model.elements[i];
    const std::array<std::int32_t, 4> coordinate = {layout.position(e.node1), layout.gradient(e.gradient1),
                                                    layout.position(e.node2), layout.gradient(e.gradient2)};
    const NodalWeights lump = lumped_mass(m, e.length);
    const Eigen::Matrix4d full = consistent_mass(m, e.length);
    for (int a = 0; a < 4; ++a) {
      lumped[coordinate[a]] += lump[a];
      if (is_lumped[i] != 0) {
        dense(coordinate[a], coordinate[a]) += 1.3 * lump[a];
        changing.push_back(coordinate[a]);
      } else {
        for (int b = 0; b < 4; ++b) dense(coordinate[a], coordinate[b]) += full(a, b);
      }
    }
  }
  // The ropes' masses have grown by 0.3 of what they were.
  present = lumped;
  for (const std::int32_t element : rope) {
    const ModelElement& e = model.elements[element];
    const NodalWeights lump = 0.3 * lumped_mass(m, e.length);
    present[layout.position(e.node1)] += lump[0];
    present[layout.gradient(e.gradient1)] += lump[1];
    present[layout.position(e.node2)] += lump[2];
    present[layout.gradient(e.gradient2)] += lump[3];
  }
  std::vector<std::int32_t> moving;
  for (std::int32_t coordinate = 0; coordinate < layout.size(); ++coordinate) {
    if (lumped[coordinate] > 0 && coordinate != layout.position(cable.nodes.front())) moving.push_back(coordinate);
  }
  CoordinateVectors force(layout.size());
  Eigen::MatrixX3d right(layout.size(), 3);
  std::mt19937 generator(5);
  for (std::int32_t coordinate = 0; coordinate < layout.size(); ++coordinate) {
    for (int axis = 0; axis < 3; ++axis) {
      right(coordinate, axis) = std::uniform_real_distribution<double>(-1, 1)(generator) * lumped[coordinate];
    }
    force.set(coordinate, right.row(coordinate).transpose());
  }
  ConsistentMass mass(model, layout, lumped, changing);
  CoordinateVectors accelerations(layout.size()), unmoved(layout.size());
  mass.kick_and_drift(force, present, 1, 0, accelerations, unmoved);
  const Eigen::MatrixX3d exact = dense(moving, moving).ldlt().solve(right(moving, Eigen::all));
  double difference = 0;
  for (std::size_t i = 0; i < moving.size(); ++i) {
    difference = std::max(difference, (accelerations.get(moving[i]) - exact.row(i).transpose()).norm());
  }
  expect_below("accelerations by the factored mass against a dense solve, relative", difference / exact.norm(), 1e-12,
               "LDL^T and the Woodbury correction of changed masses against Eigen's dense LDL^T; condition 1e3");
}

}  // namespace
}  // namespace netpocket
