// The fused pass over pairs of elements does what the forces of all elements and the update of all coordinates do one
// after the other, to the last bit.

#include "engine/dynamics/assembly/paired_elements.h"

#include <gtest/gtest.h>

#include <random>

#include "engine/dynamics/assembly/assembly.h"
#include "engine/dynamics/assembly/coordinate_vectors.h"
#include "engine/math/instruction_set.h"

namespace netpocket {
namespace {

constexpr std::int32_t kNodes = 6, kCount = 2 * kNodes * kBlockSize;  // nodes of a sector; coordinates
constexpr double kKick = 0.3, kDrift = 0.7;

// Nodes of eight sectors, in blocks: A, M, B, N, C, D. Pairs lead from A over M to B of the next sector, from B over N
// to C, and from A over D to C. D also bears an element to B, so only M and N are middles. Random elements connect A, B
// and C.
struct Net {
  std::vector<BatchElement> elements;
  CoordinateVectors coordinates{kCount}, velocities{kCount}, applied{kCount};
  AlignedVector<double> inverse_mass, weight;
  std::vector<std::uint8_t> loaded;
  std::mt19937 generator{11};

  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(generator); }
  Eigen::Vector3d random_vector() { return {uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)}; }

  explicit Net(bool variable) {
    for (std::int32_t i = 0; i < kCount; ++i) {
      coordinates.set(i, random_vector());
      velocities.set(i, random_vector());
      inverse_mass.push_back(i % 7 == 0 ? 0 : uniform(0.1, 1));
      weight.push_back(uniform(0.1, 1));
    }
    for (std::int32_t block = 0; block < kCount / kBlockSize; ++block) {
      loaded.push_back(block % 3 == 0 ? 1 : 0);
      for (int lane = 0; lane < kBlockSize && block % 3 == 0; ++lane) {
        applied.set(block * kBlockSize + lane, random_vector());
      }
    }
    add_pair(0, 1, 2, 1, variable);
    add_pair(2, 3, 4, 0, variable);
    add_pair(0, 5, 4, 0, false);
    for (std::int32_t lane = 0; lane < kBlockSize; ++lane) add(5 * kBlockSize + lane, 2 * kBlockSize + lane, 1, false);
    for (int i = 0; i < 13; ++i) add(random_end(), random_end(), 1, false);
  }

  std::int32_t random_end() {
    constexpr std::int32_t kEnds[3] = {0, 2, 4};
    return kEnds[generator() % 3] * kBlockSize + static_cast<std::int32_t>(generator() % kBlockSize);
  }
  void add(std::int32_t node1, std::int32_t node2, double length, bool variable) {
    constexpr std::int32_t kGradients = kNodes * kBlockSize;
    elements.push_back({{node1, kGradients + node1, node2, kGradients + node2},
                        length,
                        {.EA = 100, .EI = 3, .mass_per_length = 1, .axial_damping = 0.1, .bending_damping = 0.2},
                        variable});
  }
  // `shift`: to which sector the pair leads, relative to its own.
  void add_pair(std::int32_t from, std::int32_t over, std::int32_t to, std::int32_t shift, bool variable) {
    const auto first = static_cast<std::int32_t>(elements.size());
    double length[kBlockSize];
    for (double& l : length) l = uniform(0.5, 1.5);
    for (std::int32_t i = 0; i < kBlockSize; ++i) {
      add(from * kBlockSize + i, over * kBlockSize + i, length[i], variable);
      elements.back().strain_partner = first + kBlockSize + i;
    }
    for (std::int32_t i = 0; i < kBlockSize; ++i) {
      add(over * kBlockSize + i, to * kBlockSize + (i + shift) % kBlockSize, length[i], variable);
      elements.back().strain_partner = first + i;
    }
  }

  ElementBatch batch() const {
    ElementBatch result(elements);
    for (std::size_t i = 0; i < elements.size(); ++i) {
      if (elements[i].variable) result.set_length(static_cast<int>(i), elements[i].length, 0.1);
    }
    return result;
  }
  update_kernel::UpdateView view(const Assembly& assembly, const AlignedVector<double>& element_forces) {
    update_kernel::UpdateView result{};
    assembly.describe(result);
    result.element_forces = element_forces.data();
    result.inverse_mass = inverse_mass.data();
    result.applied = applied.rows();
    result.loaded = loaded.data();
    result.coordinates = coordinates.data();
    result.velocities = velocities.data();
    result.weight = weight.data();
    result.gradient_block = kNodes;
    return result;
  }
  // All coordinates and velocities, and what else a step finds.
  std::vector<double> state(const BatchPower& power, double position, double gradient) const {
    std::vector<double> values{power.dissipated, power.fed, position, gradient};
    for (std::int32_t i = 0; i < kCount; ++i) {
      for (int axis = 0; axis < 3; ++axis) {
        values.push_back(coordinates.get(i)[axis]);
        values.push_back(velocities.get(i)[axis]);
      }
    }
    return values;
  }
};

struct Kernels {
  pair_kernel::MoveKernel move;
  update_kernel::Kernel update;
};

AlignedVector<double> rows_for(const ElementBatch& batch) {
  return AlignedVector<double>(static_cast<std::size_t>(batch.block_count()) * kForceRows * kBlockSize, -7.0);
}

std::vector<double> one_after_the_other(Net net) {
  const ElementBatch batch = net.batch();
  AlignedVector<double> forces = rows_for(batch);
  const Assembly assembly(net.elements, kCount, 1);
  const BatchPower power =
      batch.forces(0, batch.block_count(), net.coordinates.rows(), net.velocities.rows(), forces.data());
  const auto update = NETPOCKET_VARIANT_OF(update_kernel, update);
  const auto fastest = update(net.view(assembly, forces), 0, assembly.block_count(), kKick, kDrift);
  return net.state(power, fastest.position, fastest.gradient);
}

// `asked`: blocks of coordinates whose forces are asked for before anything moves.
std::vector<double> fused(Net net, const Kernels& kernels, const std::vector<std::int32_t>& asked) {
  const ElementBatch batch = net.batch();
  AlignedVector<double> forces = rows_for(batch);
  PairedElements pairs(batch, net.elements, kCount);
  EXPECT_EQ(pairs.middle_count(), 4);
  const Assembly assembly(net.elements, kCount, 1, pairs.is_middle());
  pairs.forget();
  pairs.find_forces(asked, net.coordinates.rows(), net.velocities.rows(), forces.data());
  update_kernel::UpdateView view = net.view(assembly, forces);
  const auto sums = kernels.move(pairs.view(forces.data()), view, 0, batch.block_count(), kKick, kDrift);
  const auto rest = kernels.update(view, 0, assembly.block_count() - pairs.middle_count(), kKick, kDrift);
  std::vector<update_kernel::CoordinateBlock> unmoved;
  for (const std::int32_t block : pairs.unmoved_middles()) unmoved.push_back(assembly.block(block));
  view.blocks = unmoved.data();
  const auto last = kernels.update(view, 0, static_cast<int>(unmoved.size()), kKick, kDrift);
  return net.state(sums.power, std::max({sums.fastest.position, rest.position, last.position}),
                   std::max({sums.fastest.gradient, rest.gradient, last.gradient}));
}

TEST(PairedElements, TheFusedPassHasTheBitsOfTwoPasses) {
  std::vector<Kernels> variants = {{pair_kernel::baseline::move, update_kernel::baseline::update}};
  if (has(InstructionSet::avx2)) {
    variants.push_back({pair_kernel::avx2::move, update_kernel::avx2::update});
  }
  if (has(InstructionSet::avx512)) {
    variants.push_back({pair_kernel::avx512::move, update_kernel::avx512::update});
  }
  for (const bool variable : {false, true}) {
    const std::vector<double> expected = one_after_the_other(Net(variable));
    for (const Kernels& kernels : variants) {
      EXPECT_EQ(fused(Net(variable), kernels, {}), expected);
      EXPECT_EQ(fused(Net(variable), kernels, {1}), expected);         // the middle of a pair
      EXPECT_EQ(fused(Net(variable), kernels, {10, 4, 4}), expected);  // ends, one of them twice
      EXPECT_EQ(fused(Net(variable), kernels, {0, 1, 2, 3, 4, 5}), expected);
    }
  }
}

// A sum of forces that is asked for early equals the one that all elements give.
TEST(PairedElements, ForcesAskedForEarlyAreThoseOfAllElements) {
  Net net(true);
  const ElementBatch batch = net.batch();
  AlignedVector<double> all = rows_for(batch), early = all;
  batch.forces(0, batch.block_count(), net.coordinates.rows(), net.velocities.rows(), all.data());
  PairedElements pairs(batch, net.elements, kCount);
  const Assembly assembly(net.elements, kCount, 1, pairs.is_middle());
  const auto sum = NETPOCKET_VARIANT_OF(update_kernel, sum_forces);
  for (std::int32_t block = 0; block < kCount / kBlockSize; ++block) {
    pairs.forget();
    std::fill(early.begin(), early.end(), -7.0);
    pairs.find_forces(std::span(&block, 1), net.coordinates.rows(), net.velocities.rows(), early.data());
    AlignedVector<double> expected(kVectorRows * kBlockSize), found = expected;
    sum(net.view(assembly, all), &block, 1, expected.data());
    sum(net.view(assembly, early), &block, 1, found.data());
    EXPECT_EQ(found, expected) << block;
  }
}

}  // namespace
}  // namespace netpocket
