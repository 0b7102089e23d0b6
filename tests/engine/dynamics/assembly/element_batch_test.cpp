// The vectorised kernels against the readable forms, and against each other to the last bit.

#include <array>
#include <bit>
#include <numeric>
#include <random>

#include "engine/ancf/element_kernel.h"
#include "engine/ancf/mean_strain_element.h"
#include "engine/ancf/strain_pair.h"
#include "engine/dynamics/assembly/assembly.h"
#include "engine/dynamics/assembly/update_kernel.h"
#include "engine/math/instruction_set.h"
#include "tests/engine/verification_table.h"

namespace netpocket {
namespace {

// Elements that share coordinates at random, in a random state.
struct Batch {
  std::vector<BatchElement> elements;
  std::vector<double> length_rate;  // m/s, by element
  CoordinateVectors coordinates, velocities;
  std::mt19937 generator{7};

  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(generator); }

  explicit Batch(std::int32_t count) : coordinates(count), velocities(count) {
    for (std::int32_t i = 0; i < count; ++i) {
      coordinates.set(i, {uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)});
      velocities.set(i, {uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)});
    }
  }

  void add(const std::array<std::int32_t, 4>& coordinate, double compression, bool variable) {
    BatchElement element{{coordinate[0], coordinate[1], coordinate[2], coordinate[3]},
                         uniform(0.1, 2),
                         {.EA = uniform(10, 1000),
                          .EI = uniform(0.1, 10),
                          .mass_per_length = 1,
                          .axial_damping = uniform(0, 0.1),
                          .bending_damping = uniform(0, 0.1),
                          .compression = compression},
                         variable};
    elements.push_back(element);
    length_rate.push_back(variable ? uniform(-1, 1) : 0);
  }

  ElementBatch build() const {
    ElementBatch batch(elements);
    for (std::size_t i = 0; i < elements.size(); ++i) {
      if (elements[i].variable) batch.set_length(static_cast<int>(i), elements[i].length, length_rate[i]);
    }
    return batch;
  }

  ElementCoordinates gather(const CoordinateVectors& vectors, std::size_t i) const {
    ElementCoordinates q;
    for (int corner = 0; corner < 4; ++corner) q.col(corner) = vectors.get(elements[i].coordinate[corner]);
    return q;
  }

  MeanStrainElement reference(std::size_t i) const {
    return {elements[i].section, {.length = elements[i].length, .end_rate = length_rate[i]}};
  }
};

AlignedVector<double> forces_of(const ElementBatch& batch, Batch& state, BatchPower* power = nullptr) {
  AlignedVector<double> rows(static_cast<std::size_t>(batch.block_count()) * kForceRows * kBlockSize, -1.0);
  const BatchPower total =
      batch.forces(0, batch.block_count(), state.coordinates.rows(), state.velocities.rows(), rows.data());
  if (power != nullptr) *power = total;
  return rows;
}

// Gives two elements of a batch the same length and section and makes them strain partners.
void pair(Batch& batch, std::size_t first, std::size_t second) {
  BatchElement &a = batch.elements[first], &b = batch.elements[second];
  b.length = a.length;
  b.section = a.section;
  b.variable = a.variable;
  batch.length_rate[second] = batch.length_rate[first];
  a.strain_partner = static_cast<std::int32_t>(second);
  b.strain_partner = static_cast<std::int32_t>(first);
}

// Coordinates numbered as the sectors of a pocket are: eight elements read a run of eight coordinates, rotated by one
// for a neighbour sector's.
Batch regular_batch(double compression, bool variable) {
  Batch batch(8 * 8);
  for (int local = 0; local < 3; ++local) {
    for (int sector = 0; sector < 8; ++sector) {
      const int next = (sector + 1) % 8;
      batch.add({8 * local + sector, 8 * (local + 4) + sector, 8 * (local + 1) + next, 8 * (local + 5) + next},
                compression, variable);
    }
  }
  return batch;
}

// Coordinates anywhere; the last block has idle lanes.
Batch irregular_batch(double compression, bool variable) {
  Batch batch(48);
  for (int i = 0; i < 29; ++i) {
    std::array<std::int32_t, 4> coordinate{};
    for (int corner = 0; corner < 4; ++corner) coordinate[corner] = static_cast<std::int32_t>(batch.generator() % 48);
    batch.add(coordinate, compression, variable && i % 3 == 0);
  }
  return batch;
}

// As regular_batch, but one to three lanes of a block read other coordinates, at some or all corners.
Batch mostly_regular_batch(double compression, bool variable) {
  Batch batch = regular_batch(compression, variable);
  const auto change = [&](std::size_t element, int corner, std::int32_t coordinate) {
    batch.elements[element].coordinate[corner] = coordinate;
  };
  for (int corner = 0; corner < 4; ++corner) change(7, corner, 56 + corner);
  change(8, 1, 25);
  change(13, 1, 63);
  change(14, 1, 0);
  change(19, 2, 3);
  return batch;
}

// What an element exerts and takes in by the readable formulas, with its pair's strain where it has a strain partner.
struct Reference {
  ElementCoordinates force;
  double dissipated, fed;

  Reference(const Batch& state, std::size_t i) {
    const MeanStrainElement element = state.reference(i);
    const BatchElement& e = state.elements[i];
    const ElementCoordinates q = state.gather(state.coordinates, i), velocity = state.gather(state.velocities, i);
    dissipated = element.dissipated_power(q, velocity);
    fed = element.feeding_power(q, velocity);
    force = element.internal_force(q, velocity);
    if (e.strain_partner < 0) return;
    const auto strain_partner = static_cast<std::size_t>(e.strain_partner);
    const ElementCoordinates mate_q = state.gather(state.coordinates, strain_partner);
    const double own = element.strain(q), own_rate = element.strain_rate(q, velocity);
    const double strain = paired_strain(own, state.reference(strain_partner).strain(mate_q));
    const double rate = paired_strain(
        own_rate, state.reference(strain_partner).strain_rate(mate_q, state.gather(state.velocities, strain_partner)));
    const double EA = e.section.EA, c = e.section.axial_damping;
    force = element.internal_force(q, velocity, EA * (strain + c * rate));
    dissipated += EA * c * e.length * own_rate * (rate - own_rate);
    const Eigen::Vector3d chord = (q.col(2) - q.col(0)) / e.length;
    fed = state.length_rate[i] * ((EA * e.length * strain * own / 2 - element.bending_energy(q)) / e.length -
                                  chord.dot(Eigen::Vector3d(force.col(2))));
  }
};

// Largest difference of force or power, relative to the largest force.
double difference_to_reference(Batch& state) {
  BatchPower power;
  const ElementBatch batch = state.build();
  const AlignedVector<double> rows = forces_of(batch, state, &power);
  double largest = 0, difference = 0, feeding_scale = 0;
  BatchPower reference;
  for (std::size_t i = 0; i < state.elements.size(); ++i) {
    const Reference expected(state, i);
    reference.dissipated += expected.dissipated;
    reference.fed += expected.fed;
    feeding_scale += std::abs(expected.fed);
    const ElementCoordinates& force = expected.force;
    largest = std::max(largest, force.cwiseAbs().maxCoeff());
    const double* row = rows.data() + i / kBlockSize * kForceRows * kBlockSize + i % kBlockSize;
    const int columns[3] = {0, 1, 3};
    for (int part = 0; part < 9; ++part) {
      difference = std::max(difference, std::abs(row[part * kBlockSize] - force(part % 3, columns[part / 3])));
    }
  }
  const double dissipated = std::abs(power.dissipated - reference.dissipated) / reference.dissipated;
  const double fed = feeding_scale == 0 ? std::abs(power.fed) : std::abs(power.fed - reference.fed) / feeding_scale;
  return std::max({difference / largest, dissipated, fed});
}

class VerificationBatch : public test::VerificationTest {};

TEST_F(VerificationBatch, EqualsTheReferenceElement) {
  const std::string reason = "mean_strain_element.h; sums of some 50 terms of unit round-off 1.1e-16";
  for (const double compression : {1.0, 0.25, 0.0}) {
    for (const bool variable : {false, true}) {
      Batch regular = regular_batch(compression, variable), irregular = irregular_batch(compression, variable);
      Batch mostly_regular = mostly_regular_batch(compression, variable);
      const std::string what = std::string(variable ? "variable" : "constant") + " length, compression " +
                               std::to_string(compression).substr(0, 4);
      expect_below("relative force difference, regular coordinates, " + what, difference_to_reference(regular), 1e-14,
                   reason);
      expect_below("relative force difference, scattered coordinates, " + what, difference_to_reference(irregular),
                   1e-14, reason);
      expect_below("relative force difference, coordinates of which few are scattered, " + what,
                   difference_to_reference(mostly_regular), 1e-14, reason);
    }
  }
}

TEST(ElementBatch, ReadsARunWhereMostLanesDo) {
  const ElementBatch batch = mostly_regular_batch(1, false).build();
  const ElementBlock &first = batch.block(0), &second = batch.block(1), &third = batch.block(2);
  for (int corner = 0; corner < 4; ++corner) EXPECT_EQ(first.odd[corner], 1U << 7) << corner;
  EXPECT_EQ(second.odd[1], 1U << 0 | 1U << 5 | 1U << 6);
  EXPECT_EQ(third.odd[2], 1U << 3);
  EXPECT_EQ(third.base[2], 24);
  EXPECT_EQ(third.rotation[2], 1);
  EXPECT_FALSE(first.whole || second.whole || third.whole);
  const ElementBatch irregular = irregular_batch(1, false).build();
  EXPECT_EQ(irregular.block(0).base[0], -1);
}

// Pairs whose strain partners stand lane by lane in the next block, and anywhere.
Batch with_pairs(Batch batch, bool regular) {
  if (regular) {
    for (std::size_t lane = 0; lane < 8; ++lane) pair(batch, lane, 8 + lane);
  } else {
    for (std::size_t i = 0; i < 20; i += 5) pair(batch, i, i + 9);
  }
  return batch;
}

TEST_F(VerificationBatch, PairsEqualTheReference) {
  for (const bool variable : {false, true}) {
    Batch regular = with_pairs(regular_batch(1, variable), true);
    Batch irregular = with_pairs(irregular_batch(1, variable), false);
    const std::string what = std::string(variable ? "variable" : "constant") + " length";
    expect_below("relative force difference, pairs in neighbouring blocks, " + what, difference_to_reference(regular),
                 1e-14, "strain_pair.h; sums of some 50 terms of unit round-off 1.1e-16");
    expect_below("relative force difference, scattered pairs, " + what, difference_to_reference(irregular), 1e-14,
                 "strain_pair.h; sums of some 50 terms of unit round-off 1.1e-16");
  }
}

// Forces of the pair = -d/dq of the energy that strain_pair.h writes down.
TEST_F(VerificationBatch, PairForceIsTheGradientOfItsEnergy) {
  Batch state = with_pairs(regular_batch(1, false), true);
  for (BatchElement& e : state.elements) e.section.axial_damping = e.section.bending_damping = 0;
  const auto energy = [&] {
    double sum = 0;
    for (std::size_t i = 0; i < 2; ++i)
      sum += state.reference(8 * i).bending_energy(state.gather(state.coordinates, 8 * i));
    const double first = state.reference(0).strain(state.gather(state.coordinates, 0));
    const double second = state.reference(8).strain(state.gather(state.coordinates, 8));
    const double mean = (first + second) / 2, difference = first - second;
    const BatchElement& e = state.elements[0];
    return sum + e.section.EA * e.length * (mean * mean + kPairVariation * difference * difference / 4);
  };
  const AlignedVector<double> rows = forces_of(state.build(), state);
  const std::int32_t coordinate =
      state.elements[0].coordinate[0];  // the pair's first node: no other element of the pair has it
  const Eigen::Vector3d place = state.coordinates.get(coordinate);
  constexpr double kStep = 1e-6;
  double worst = 0, largest = 0;
  for (int axis = 0; axis < 3; ++axis) {
    Eigen::Vector3d moved = place;
    moved[axis] += kStep;
    state.coordinates.set(coordinate, moved);
    const double above = energy();
    moved[axis] -= 2 * kStep;
    state.coordinates.set(coordinate, moved);
    const double slope = (above - energy()) / (2 * kStep);
    state.coordinates.set(coordinate, place);
    worst = std::max(worst, std::abs(slope - rows[axis * kBlockSize]));
    largest = std::max(largest, std::abs(slope));
  }
  expect_below("pair's force against the slope of its energy, relative", worst / largest, 1e-7,
               "central differences of second order");
}

TEST_F(VerificationBatch, InstructionSetsGiveTheSameBits) {
  for (Batch state : {with_pairs(irregular_batch(1, false), false), with_pairs(irregular_batch(1, true), false),
                      mostly_regular_batch(1, false), mostly_regular_batch(1, true)}) {
    const ElementBatch batch = state.build();
    const auto run = [&](element_kernel::Kernel kernel) {
      AlignedVector<double> rows(static_cast<std::size_t>(batch.block_count()) * kForceRows * kBlockSize);
      const BatchPower power =
          kernel(batch.view(), 0, batch.block_count(), state.coordinates.rows(), state.velocities.rows(), rows.data());
      rows.insert(rows.end(), {power.dissipated, power.fed});
      return rows;
    };
    const auto baseline = run(element_kernel::baseline::element_forces);
    if (has(InstructionSet::avx2)) {
      EXPECT_EQ(run(element_kernel::avx2::element_forces), baseline);
    }
    if (has(InstructionSet::avx512)) {
      EXPECT_EQ(run(element_kernel::avx512::element_forces), baseline);
    }
  }
}

// One update of all coordinates by a kernel; returns coordinates and velocities in a row.
std::vector<double> updated(Batch state, update_kernel::Kernel kernel, const Assembly& assembly,
                            const AlignedVector<double>& element_forces, AlignedVector<double>& inverse_mass,
                            CoordinateVectors& applied) {
  update_kernel::UpdateView view{};
  assembly.describe(view);
  view.element_forces = element_forces.data();
  view.inverse_mass = inverse_mass.data();
  view.applied = applied.rows();
  const std::vector<std::uint8_t> loaded(static_cast<std::size_t>(assembly.block_count()), 1);
  view.loaded = loaded.data();
  view.coordinates = state.coordinates.data();
  view.velocities = state.velocities.data();
  const AlignedVector<double> weight(static_cast<std::size_t>(state.coordinates.size()), 0.5);
  view.weight = weight.data();
  view.gradient_block = assembly.block_count() / 2;
  const update_kernel::Fastest fastest = kernel(view, 0, assembly.block_count(), 0.01, 0.02);
  std::vector<double> values;
  double squares[2] = {};
  for (std::int32_t coordinate = 0; coordinate < state.coordinates.size(); ++coordinate) {
    const bool is_position = coordinate / kBlockSize < view.gradient_block;
    double& largest = squares[is_position ? 0 : 1];
    largest = std::max(largest, (is_position ? 1 : 0.25) * state.velocities.get(coordinate).squaredNorm());
  }
  EXPECT_NEAR(fastest.position, squares[0], 1e-12 * squares[0]);
  EXPECT_NEAR(fastest.gradient, squares[1], 1e-12 * squares[1]);
  EXPECT_GT(squares[0] * squares[1], 0);
  for (std::int32_t coordinate = 0; coordinate < state.coordinates.size(); ++coordinate) {
    for (int axis = 0; axis < 3; ++axis) {
      values.push_back(state.coordinates.get(coordinate)[axis]);
      values.push_back(state.velocities.get(coordinate)[axis]);
    }
  }
  return values;
}

// Rows of the forces on all blocks of coordinates.
AlignedVector<double> summed(const Assembly& assembly, const AlignedVector<double>& element_forces,
                             CoordinateVectors& applied, update_kernel::SumKernel kernel) {
  const std::vector<std::uint8_t> loaded(static_cast<std::size_t>(assembly.block_count()), 1);
  std::vector<std::int32_t> blocks(static_cast<std::size_t>(assembly.block_count()));
  std::iota(blocks.begin(), blocks.end(), 0);
  update_kernel::UpdateView view{};
  assembly.describe(view);
  view.element_forces = element_forces.data();
  view.applied = applied.rows();
  view.loaded = loaded.data();
  AlignedVector<double> rows(blocks.size() * kVectorRows * kBlockSize);
  kernel(view, blocks.data(), blocks.size(), rows.data());
  return rows;
}

TEST_F(VerificationBatch, UpdateEqualsAPlainLoop) {
  const std::pair<const char*, Batch> cases[] = {{"regular", regular_batch(1, false)},
                                                 {"scattered", irregular_batch(1, false)},
                                                 {"mostly regular", mostly_regular_batch(1, false)}};
  for (auto [name, state] : cases) {
    const ElementBatch batch = state.build();
    const AlignedVector<double> element_forces = forces_of(batch, state);
    const std::int32_t indices = state.coordinates.size();
    const Assembly assembly(state.elements, indices, 1);
    AlignedVector<double> inverse_mass(indices);
    CoordinateVectors applied(indices);
    for (std::int32_t coordinate = 0; coordinate < indices; ++coordinate) {
      inverse_mass[coordinate] = coordinate % 5 == 0 ? 0 : state.uniform(0.1, 1);
      applied.set(coordinate, {state.uniform(-1, 1), state.uniform(-1, 1), state.uniform(-1, 1)});
    }
    // The plain loop: v += dt/m F, x += dt v.
    std::vector<Eigen::Vector3d> force(indices);
    for (std::int32_t coordinate = 0; coordinate < indices; ++coordinate) force[coordinate] = applied.get(coordinate);
    for (std::size_t i = 0; i < state.elements.size(); ++i) {
      const ElementCoordinates resisting =
          state.reference(i).internal_force(state.gather(state.coordinates, i), state.gather(state.velocities, i));
      for (int corner = 0; corner < 4; ++corner) force[state.elements[i].coordinate[corner]] -= resisting.col(corner);
    }
    const auto run = [&, &state = state](update_kernel::Kernel kernel) {
      return updated(state, kernel, assembly, element_forces, inverse_mass, applied);
    };
    const std::vector<double> baseline = run(update_kernel::baseline::update);
    const auto sum = [&](update_kernel::SumKernel kernel) { return summed(assembly, element_forces, applied, kernel); };
    const AlignedVector<double> sums = sum(update_kernel::baseline::sum_forces);
    double difference = 0, round_off = 0;
    for (std::int32_t coordinate = 0; coordinate < indices; ++coordinate) {
      const Eigen::Vector3d velocity =
          state.velocities.get(coordinate) + 0.01 * inverse_mass[coordinate] * force[coordinate];
      const Eigen::Vector3d value = state.coordinates.get(coordinate) + 0.02 * velocity;
      const double* row = sums.data() + coordinate / kBlockSize * kVectorRows * kBlockSize + coordinate % kBlockSize;
      EXPECT_LT((force[coordinate] - Eigen::Vector3d(row[0], row[kBlockSize], row[2 * kBlockSize])).norm(), 1e-9);
      round_off = std::max(round_off, 1e-15 * (1 + 0.01 * force[coordinate].norm()));
      for (int axis = 0; axis < 3; ++axis) {
        difference = std::max(difference, std::abs(baseline[6 * coordinate + 2 * axis] - value[axis]));
        difference = std::max(difference, std::abs(baseline[6 * coordinate + 2 * axis + 1] - velocity[axis]));
      }
    }
    expect_below(std::string("coordinate update against a plain loop, ") + name + " coordinates",
                 difference / round_off, 1,
                 "in units of 1e-15 of the largest change; only the order of summation differs");
    if (has(InstructionSet::avx2)) {
      EXPECT_EQ(run(update_kernel::avx2::update), baseline);
      EXPECT_EQ(sum(update_kernel::avx2::sum_forces), sums);
    }
    if (has(InstructionSet::avx512)) {
      EXPECT_EQ(run(update_kernel::avx512::update), baseline);
      EXPECT_EQ(sum(update_kernel::avx512::sum_forces), sums);
    }
  }
}

}  // namespace
}  // namespace netpocket
