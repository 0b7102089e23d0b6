#include "engine/ancf/element_batch.h"

#include <algorithm>
#include <bit>

#include "engine/ancf/element_kernel.h"
#include "engine/math/instruction_set.h"

namespace netpocket {
namespace {

struct Kernels {
  element_kernel::Kernel forces;
  element_kernel::StateKernel states;
};

const Kernels& kernels() {
  static const Kernels chosen = {NETPOCKET_VARIANT_OF(element_kernel, element_forces),
                                 NETPOCKET_VARIANT_OF(element_kernel, element_states)};
  return chosen;
}

// More lanes than this that read coordinates apart from the run are dearer than to read all lanes one by one.
constexpr int kMostOddLanes = 3;

// Fills base, rotation and odd of a corner: the run that most lanes read, if only few lanes do not.
void find_run(ElementBlock& block, int corner) {
  const std::int32_t* coordinate = block.coordinate[corner];
  block.base[corner] = -1;
  block.rotation[corner] = block.odd[corner] = 0;
  int fewest = kMostOddLanes + 1;
  for (int candidate = 0; candidate < kBlockSize; ++candidate) {
    const std::int32_t base = coordinate[candidate] / kBlockSize * kBlockSize;
    const std::int32_t rotation = (coordinate[candidate] - base - candidate + kBlockSize) % kBlockSize;
    unsigned odd = 0;
    for (int lane = 0; lane < kBlockSize; ++lane) {
      if (coordinate[lane] != base + (lane + rotation) % kBlockSize) odd |= 1U << lane;
    }
    if (std::popcount(odd) >= fewest) continue;
    fewest = std::popcount(odd);
    block.base[corner] = base;
    block.rotation[corner] = rotation;
    block.odd[corner] = static_cast<std::uint8_t>(odd);
  }
}

void fill_lane(ElementBlock& block, SectionRows& rows, int lane, const BatchElement& element) {
  for (int corner = 0; corner < 4; ++corner) block.coordinate[corner][lane] = element.coordinate[corner];
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

// Fills a lane without an element so that it reads valid coordinates and exerts no force.
void fill_idle_lane(ElementBlock& block, SectionRows& rows, int lane) {
  BatchElement idle{};
  std::copy_n(
      std::begin({block.coordinate[0][0], block.coordinate[1][0], block.coordinate[2][0], block.coordinate[3][0]}), 4,
      idle.coordinate);
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
  find_strain_partners(elements);
  find_whole();
}

void ElementBatch::find_whole() {
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    ElementBlock& block = blocks_[b];
    block.whole = block.reads_runs() && block.pairing != Pairing::elsewhere &&
                  (block.pairing != Pairing::first || blocks_[b + 1].reads_runs());
  }
}

void ElementBatch::find_strain_partners(std::span<const BatchElement> elements) {
  const auto strain_partner_of = [&](std::size_t element) {
    return element < elements.size() ? elements[element].strain_partner : -1;
  };
  // Whether the strain partner of each lane is the same lane of the block b + distance.
  const auto aligned = [&](std::size_t b, int distance) {
    for (std::size_t i = b * kBlockSize; i < (b + 1) * kBlockSize; ++i) {
      if (strain_partner_of(i) < 0 || strain_partner_of(i) != static_cast<std::int32_t>(i) + distance * kBlockSize)
        return false;
    }
    return true;
  };
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    ElementBlock& block = blocks_[b];
    block.pairing = Pairing::none;
    if (aligned(b, 1)) {
      block.pairing = Pairing::first;
    } else if (aligned(b, -1)) {
      block.pairing = Pairing::second;
    } else {
      SectionRows unused{};
      ElementBlock strain_partners = block;
      for (std::size_t i = b * kBlockSize; i < (b + 1) * kBlockSize; ++i) {
        if (strain_partner_of(i) < 0) continue;
        block.pairing = Pairing::elsewhere;
        fill_lane(strain_partners, unused, static_cast<int>(i % kBlockSize),
                  elements[static_cast<std::size_t>(strain_partner_of(i))]);
      }
      if (block.pairing == Pairing::none) continue;
      for (int corner = 0; corner < 4; ++corner) find_run(strain_partners, corner);
      block.strain_partners = static_cast<std::int32_t>(strain_partners_.size());
      strain_partners_.push_back(strain_partners);
    }
  }
}

// Consecutive blocks mostly have the same sections, so the search begins with the newest.
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
  if (block.pairing != Pairing::elsewhere) return;
  ElementBlock& strain_partners = strain_partners_[block.strain_partners];  // strain partners have the same length
  strain_partners.length[lane] = length;
  strain_partners.inverse_length[lane] = block.inverse_length[lane];
  strain_partners.length_rate[lane] = block.length_rate[lane];
}

BatchPower ElementBatch::forces(int first, int last, const CoordinateRows& coordinates,
                                const CoordinateRows& velocities, double* forces) const {
  return kernels().forces(view(), first, last, coordinates, velocities, forces);
}

void ElementBatch::states(int first, int last, const CoordinateRows& coordinates, const CoordinateRows& velocities,
                          double* states) const {
  kernels().states(view(), first, last, coordinates, velocities, states);
}

}  // namespace netpocket
