#include "engine/dynamics/assembly/paired_elements.h"

#include <algorithm>
#include <set>

namespace netpocket {
namespace {

struct PairKernels {
  pair_kernel::MoveKernel move;
  pair_kernel::ForceKernel forces;
};

const PairKernels& pair_kernels() {
  static const PairKernels chosen = {NETPOCKET_VARIANT_OF(pair_kernel, move),
                                     NETPOCKET_VARIANT_OF(pair_kernel, forces)};
  return chosen;
}

}  // namespace

PairedElements::PairedElements(const ElementBatch& batch, std::span<const BatchElement> elements,
                               std::int32_t coordinate_count)
    : batch_(batch),
      middles_(static_cast<std::size_t>(batch.block_count())),
      is_middle_(static_cast<std::size_t>(coordinate_count / kBlockSize), 0),
      known_(static_cast<std::size_t>(batch.block_count()), 0),
      powers_(static_cast<std::size_t>(batch.block_count()) * pair_kernel::kPowerRows * kBlockSize, 0.0) {
  find_middles(elements, coordinate_count);
  list_elements(elements);
}

// A block of coordinates is in the middle of a pair if the lanes of both element blocks read it in its own order and no
// other element acts on it.
void PairedElements::find_middles(std::span<const BatchElement> elements, std::int32_t coordinate_count) {
  std::vector<int> acting(static_cast<std::size_t>(coordinate_count), 0);
  for (const BatchElement& element : elements) {
    for (const std::int32_t coordinate : element.coordinate) ++acting[static_cast<std::size_t>(coordinate)];
  }
  // The block between a corner of one block and a corner of the next; -1: none.
  const auto block_between = [&](const ElementBlock& one, int corner, const ElementBlock& next, int corner_of_next) {
    const std::int32_t base = one.base[corner];
    const bool shared = one.reads_run(corner) && next.reads_run(corner_of_next) && next.base[corner_of_next] == base &&
                        one.rotation[corner] == 0 && next.rotation[corner_of_next] == 0;
    const bool alone = shared && std::all_of(acting.begin() + base, acting.begin() + base + kBlockSize,
                                             [](int count) { return count == 2; });
    return alone ? base / kBlockSize : -1;
  };
  for (int i = 0; i + 1 < batch_.block_count(); ++i) {
    if (batch_.block(i).pairing != Pairing::first) continue;
    const ElementBlock &one = batch_.block(i), &next = batch_.block(i + 1);
    const pair_kernel::PairMiddle middle{block_between(one, 2, next, 0), block_between(one, 3, next, 1)};
    if (middle.position < 0 || middle.gradient < 0 || !one.whole) continue;
    middles_[static_cast<std::size_t>(i)] = middle;
    is_middle_[static_cast<std::size_t>(middle.position)] = is_middle_[static_cast<std::size_t>(middle.gradient)] = 1;
    middle_count_ += 2;
  }
}

void PairedElements::list_elements(std::span<const BatchElement> elements) {
  std::vector<std::set<std::int32_t>> acting(is_middle_.size());
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const auto block = static_cast<std::int32_t>(i / kBlockSize);
    const std::int32_t first = batch_.block(block).pairing == Pairing::second ? block - 1 : block;
    for (const std::int32_t coordinate : elements[i].coordinate) {
      acting[static_cast<std::size_t>(coordinate / kBlockSize)].insert(first);
    }
  }
  for (const std::set<std::int32_t>& blocks : acting) {
    acting_.insert(acting_.end(), blocks.begin(), blocks.end());
    acting_end_.push_back(static_cast<std::int32_t>(acting_.size()));
  }
}

pair_kernel::PairView PairedElements::view(double* element_forces) const {
  return {.batch = batch_.view(),
          .middles = middles_.data(),
          .known = known_.data(),
          .element_forces = element_forces,
          .powers = powers_.data()};
}

void PairedElements::forget() {
  for (const std::int32_t block : known_blocks_) known_[static_cast<std::size_t>(block)] = 0;
  known_blocks_.clear();
  unmoved_.clear();
}

void PairedElements::find_forces(std::span<const std::int32_t> coordinate_blocks, const CoordinateRows& coordinates,
                                 const CoordinateRows& velocities, double* element_forces) {
  wanted_.clear();
  const auto note = [&](std::int32_t block) {
    known_[static_cast<std::size_t>(block)] = 1;
    known_blocks_.push_back(block);
  };
  for (const std::int32_t coordinate_block : coordinate_blocks) {
    const std::int32_t first = coordinate_block == 0 ? 0 : acting_end_[static_cast<std::size_t>(coordinate_block) - 1];
    for (std::int32_t i = first; i < acting_end_[static_cast<std::size_t>(coordinate_block)]; ++i) {
      const std::int32_t block = acting_[static_cast<std::size_t>(i)];
      if (known_[static_cast<std::size_t>(block)] != 0) continue;
      wanted_.push_back(block);
      note(block);
      if (batch_.block(block).pairing == Pairing::first) note(block + 1);
      const pair_kernel::PairMiddle& middle = middles_[static_cast<std::size_t>(block)];
      if (middle.position >= 0) unmoved_.insert(unmoved_.end(), {middle.position, middle.gradient});
    }
  }
  if (wanted_.empty()) return;
  pair_kernels().forces(view(element_forces), coordinates, velocities, wanted_.data(), wanted_.size());
}

pair_kernel::PairSums PairedElements::move(const update_kernel::UpdateView& motion, int first, int last, double kick,
                                           double drift, double* element_forces) const {
  return pair_kernels().move(view(element_forces), motion, first, last, kick, drift);
}

}  // namespace netpocket
