// The vectorised kernels against the readable forms, and against each other to the last bit.

#include <array>
#include <random>

#include "engine/ancf/element_kernel.h"
#include "engine/ancf/mean_strain_element.h"
#include "engine/dynamics/assembly.h"
#include "engine/dynamics/slot_kernel.h"
#include "tests/engine/verification_table.h"

namespace netpocket {
namespace {

bool runs_avx2() { return __builtin_cpu_supports("avx2"); }
bool runs_avx512() {
  return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl");
}

// Elements that share slots at random, in a random state.
struct Batch {
  std::vector<BatchElement> elements;
  std::vector<double> length_rate;  // m/s, by element
  SlotVectors coordinates, velocities;
  std::mt19937 generator{7};

  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(generator); }

  explicit Batch(std::int32_t slots) : coordinates(slots), velocities(slots) {
    for (std::int32_t i = 0; i < slots; ++i) {
      coordinates.set(i, {uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)});
      velocities.set(i, {uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)});
    }
  }

  void add(const std::array<std::int32_t, 4>& slot, double compression, bool variable) {
    BatchElement element{{slot[0], slot[1], slot[2], slot[3]},
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

  ElementCoordinates gather(const SlotVectors& vectors, std::size_t i) const {
    ElementCoordinates q;
    for (int corner = 0; corner < 4; ++corner) q.col(corner) = vectors.get(elements[i].slot[corner]);
    return q;
  }

  MeanStrainElement reference(std::size_t i) const {
    return {elements[i].section, {.length = elements[i].length, .end_rate = length_rate[i]}};
  }
};

AlignedVector<double> forces_of(const ElementBatch& batch, Batch& state, BatchPower* power = nullptr) {
  AlignedVector<double> rows(static_cast<std::size_t>(batch.block_count()) * kForceRows * kBlockSize, -1.0);
  const BatchPower total =
      batch.forces(0, batch.block_count(), state.coordinates.arrays(), state.velocities.arrays(), rows.data());
  if (power != nullptr) *power = total;
  return rows;
}

// Slots numbered as the sectors of a pocket are: eight elements read a run of eight slots, rotated by one for a
// neighbour sector's.
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

// Slots anywhere; the last block has idle lanes.
Batch irregular_batch(double compression, bool variable) {
  Batch batch(48);
  for (int i = 0; i < 29; ++i) {
    std::array<std::int32_t, 4> slot{};
    for (int corner = 0; corner < 4; ++corner) slot[corner] = static_cast<std::int32_t>(batch.generator() % 48);
    batch.add(slot, compression, variable && i % 3 == 0);
  }
  return batch;
}

// Largest difference of force or power, relative to the largest force.
double difference_to_reference(Batch& state) {
  BatchPower power;
  const ElementBatch batch = state.build();
  const AlignedVector<double> rows = forces_of(batch, state, &power);
  double largest = 0, difference = 0, feeding_scale = 0;
  BatchPower reference;
  for (std::size_t i = 0; i < state.elements.size(); ++i) {
    const ElementCoordinates q = state.gather(state.coordinates, i), velocity = state.gather(state.velocities, i);
    const ElementCoordinates force = state.reference(i).internal_force(q, velocity);
    reference.dissipated += state.reference(i).dissipated_power(q, velocity);
    const double fed = state.reference(i).feeding_power(q, velocity);
    reference.fed += fed;
    feeding_scale += std::abs(fed);
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
      const std::string what = std::string(variable ? "variable" : "constant") + " length, compression " +
                               std::to_string(compression).substr(0, 4);
      expect_below("relative force difference, regular slots, " + what, difference_to_reference(regular), 1e-14,
                   reason);
      expect_below("relative force difference, scattered slots, " + what, difference_to_reference(irregular), 1e-14,
                   reason);
    }
  }
}

TEST_F(VerificationBatch, InstructionSetsGiveTheSameBits) {
  for (const bool variable : {false, true}) {
    Batch state = irregular_batch(0.5, variable);
    const ElementBatch batch = state.build();
    const auto run = [&](element_kernel::Kernel kernel) {
      AlignedVector<double> rows(static_cast<std::size_t>(batch.block_count()) * kForceRows * kBlockSize);
      const BatchPower power = kernel(batch.view(), 0, batch.block_count(), state.coordinates.arrays(),
                                      state.velocities.arrays(), rows.data());
      rows.insert(rows.end(), {power.dissipated, power.fed});
      return rows;
    };
    const auto baseline = run(element_kernel::baseline::element_forces);
    if (runs_avx2()) {
      EXPECT_EQ(run(element_kernel::avx2::element_forces), baseline);
    }
    if (runs_avx512()) {
      EXPECT_EQ(run(element_kernel::avx512::element_forces), baseline);
    }
  }
}

// One update of all slots by a kernel; returns coordinates and velocities in a row.
std::vector<double> updated(Batch state, slot_kernel::Kernel kernel, const Assembly& assembly,
                            const AlignedVector<double>& element_forces, AlignedVector<double>& inverse_mass,
                            SlotVectors& applied) {
  slot_kernel::UpdateView view{};
  assembly.describe(view);
  view.element_forces = element_forces.data();
  view.inverse_mass = inverse_mass.data();
  view.applied = applied.arrays();
  view.coordinates = state.coordinates.arrays();
  view.velocities = state.velocities.arrays();
  kernel(view, 0, assembly.block_count(), 0.01, 0.02);
  std::vector<double> values;
  for (std::int32_t slot = 0; slot < state.coordinates.size(); ++slot) {
    for (int axis = 0; axis < 3; ++axis) {
      values.push_back(state.coordinates.get(slot)[axis]);
      values.push_back(state.velocities.get(slot)[axis]);
    }
  }
  return values;
}

TEST_F(VerificationBatch, SlotUpdateEqualsAPlainLoop) {
  for (Batch state : {regular_batch(1, false), irregular_batch(1, false)}) {
    const ElementBatch batch = state.build();
    const AlignedVector<double> element_forces = forces_of(batch, state);
    const std::int32_t slots = state.coordinates.size();
    const Assembly assembly(state.elements, slots);
    AlignedVector<double> inverse_mass(slots);
    SlotVectors applied(slots);
    for (std::int32_t slot = 0; slot < slots; ++slot) {
      inverse_mass[slot] = slot % 5 == 0 ? 0 : state.uniform(0.1, 1);
      applied.set(slot, {state.uniform(-1, 1), state.uniform(-1, 1), state.uniform(-1, 1)});
    }
    // The plain loop: v += dt/m F, x += dt v.
    std::vector<Eigen::Vector3d> force(slots);
    for (std::int32_t slot = 0; slot < slots; ++slot) force[slot] = applied.get(slot);
    for (std::size_t i = 0; i < state.elements.size(); ++i) {
      const ElementCoordinates resisting =
          state.reference(i).internal_force(state.gather(state.coordinates, i), state.gather(state.velocities, i));
      for (int corner = 0; corner < 4; ++corner) force[state.elements[i].slot[corner]] -= resisting.col(corner);
    }
    const auto run = [&](slot_kernel::Kernel kernel) {
      return updated(state, kernel, assembly, element_forces, inverse_mass, applied);
    };
    const std::vector<double> baseline = run(slot_kernel::baseline::update);
    double difference = 0, round_off = 0;
    for (std::int32_t slot = 0; slot < slots; ++slot) {
      const Eigen::Vector3d velocity = state.velocities.get(slot) + 0.01 * inverse_mass[slot] * force[slot];
      const Eigen::Vector3d coordinate = state.coordinates.get(slot) + 0.02 * velocity;
      EXPECT_LT((force[slot] - applied.get(slot) - assembly.element_force(slot, element_forces.data())).norm(), 1e-9);
      round_off = std::max(round_off, 1e-15 * (1 + 0.01 * force[slot].norm()));
      for (int axis = 0; axis < 3; ++axis) {
        difference = std::max(difference, std::abs(baseline[6 * slot + 2 * axis] - coordinate[axis]));
        difference = std::max(difference, std::abs(baseline[6 * slot + 2 * axis + 1] - velocity[axis]));
      }
    }
    expect_below(std::string("slot update against a plain loop, ") + (slots == 64 ? "regular" : "scattered") + " slots",
                 difference / round_off, 1,
                 "in units of 1e-15 of the largest change; only the order of summation differs");
    if (runs_avx2()) {
      EXPECT_EQ(run(slot_kernel::avx2::update), baseline);
    }
    if (runs_avx512()) {
      EXPECT_EQ(run(slot_kernel::avx512::update), baseline);
    }
  }
}

}  // namespace
}  // namespace netpocket
