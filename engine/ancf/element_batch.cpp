#include "engine/ancf/element_batch.h"

#include <algorithm>

#include "engine/ancf/element_kernel.h"
#include "engine/ancf/instruction_set.h"

namespace netpocket {
namespace {

element_kernel::Kernel choose_kernel() {
  switch (instruction_set()) {
    case InstructionSet::avx512:
      return element_kernel::avx512::element_forces;
    case InstructionSet::avx2:
      return element_kernel::avx2::element_forces;
    case InstructionSet::baseline:
      break;
  }
  return element_kernel::baseline::element_forces;
}

// Fills base and rotation of a corner whose lanes read an aligned run of eight slots, rotated.
void find_run(ElementBlock& block, int corner) {
  const std::int32_t* slot = block.slot[corner];
  const std::int32_t base = slot[0] / kBlockSize * kBlockSize;
  const std::int32_t rotation = slot[0] - base;
  bool regular = true;
  for (int lane = 0; lane < kBlockSize; ++lane) {
    regular = regular && slot[lane] == base + (lane + rotation) % kBlockSize;
  }
  block.base[corner] = regular ? base : -1;
  block.rotation[corner] = regular ? rotation : 0;
}

void fill_lane(ElementBlock& block, SectionRows& rows, int lane, const BatchElement& element) {
  for (int corner = 0; corner < 4; ++corner) block.slot[corner][lane] = element.slot[corner];
  const CableSection& section = element.section;
  block.length[lane] = element.length;
  block.inverse_length[lane] = 1.0 / element.length;
  block.length_rate[lane] = 0;
  block.variable = block.variable || element.variable;
  rows.axial_stiffness[lane] = section.EA;
  rows.compression_stiffness[lane] = section.EA * section.compression;
  rows.axial_damping[lane] = section.axial_damping;
  rows.bending_rigidity[lane] = section.EI;
  rows.bending_damping[lane] = section.bending_damping;
}

// A lane without an element: reads valid coordinates and exerts no force.
void fill_idle_lane(ElementBlock& block, SectionRows& rows, int lane) {
  BatchElement idle{};
  std::copy_n(std::begin({block.slot[0][0], block.slot[1][0], block.slot[2][0], block.slot[3][0]}), 4, idle.slot);
  idle.length = 1;
  idle.section = CableSection{};
  idle.section.EA = idle.section.EI = 0;
  fill_lane(block, rows, lane, idle);
}

}  // namespace

ElementBatch::ElementBatch(std::span<const BatchElement> elements)
    : element_count_(static_cast<int>(elements.size())), blocks_((elements.size() + kBlockSize - 1) / kBlockSize) {
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    ElementBlock& block = blocks_[b];
    SectionRows rows{};
    for (int lane = 0; lane < kBlockSize; ++lane) {
      const std::size_t element = b * kBlockSize + static_cast<std::size_t>(lane);
      if (element < elements.size()) {
        fill_lane(block, rows, lane, elements[element]);
      } else {
        fill_idle_lane(block, rows, lane);
      }
    }
    for (int corner = 0; corner < 4; ++corner) find_run(block, corner);
    block.section = index_of(rows);
  }
}

// Blocks in a row are mostly alike, so the search begins with the newest.
std::int32_t ElementBatch::index_of(const SectionRows& rows) {
  const auto found = std::find(sections_.rbegin(), sections_.rend(), rows);
  if (found != sections_.rend()) return static_cast<std::int32_t>(sections_.rend() - found) - 1;
  sections_.push_back(rows);
  return static_cast<std::int32_t>(sections_.size()) - 1;
}

void ElementBatch::set_length(int element, double length, double rate) {
  ElementBlock& block = blocks_[element / kBlockSize];
  const int lane = element % kBlockSize;
  block.length[lane] = length;
  block.inverse_length[lane] = 1.0 / length;
  block.length_rate[lane] = rate / length;
}

BatchPower ElementBatch::forces(int first, int last, const SlotArrays& coordinates, const SlotArrays& velocities,
                                double* forces) const {
  static const element_kernel::Kernel kernel = choose_kernel();
  return kernel(view(), first, last, coordinates, velocities, forces);
}

}  // namespace netpocket
