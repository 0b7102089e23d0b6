#pragma once
// Internal forces of many mean-strain cable elements at once. It is the fast form of mean_strain_element.h; a test
// requires both to agree to round-off.
//
// Elements are computed in blocks of eight lanes. If consecutive elements have consecutive coordinates (as in the eight
// sectors of a pocket), the kernel reads a block without gathering.
//
// A "coordinate" is one vector-valued unknown: the position of a node or a gradient.

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "engine/ancf/cable_section.h"
#include "engine/math/block_size.h"

namespace netpocket {

// The vectors of all coordinates in memory. Each block of eight coordinates has three rows of eight values: x, y, z.
// 64-byte aligned.
struct CoordinateRows {
  const double* first = nullptr;
};
inline constexpr int kVectorRows = 3;

struct BatchElement {
  std::int32_t coordinate[4];  // r1, g1, r2, g2
  double length;               // m
  CableSection section;
  bool variable = false;             // whether the length changes during the run (set_length)
  std::int32_t strain_partner = -1;  // element that shares its axial strain (strain_pair.h); -1: none
};

// Where the elements of a block find the strain of their strain partners.
enum class Pairing : std::uint8_t {
  none,      // no element has a strain partner
  first,     // the strain partner of each lane is the same lane of the next block
  second,    // the strain partner of each lane is the same lane of the previous block
  elsewhere  // any other arrangement: the block has a copy of its strain partners' data
};

// Section properties of the elements of a block, by lane. Few blocks differ, so they refer to rows of a common table,
// which stays in the fastest cache.
struct alignas(64) SectionRows {
  double axial_stiffness[kBlockSize];        // EA, N
  double compression_stiffness[kBlockSize];  // EA in compression, N
  double axial_damping[kBlockSize];          // c, s
  double bending_rigidity[kBlockSize];       // EI, N m^2
  double bending_damping[kBlockSize];        // c, s

  bool operator==(const SectionRows&) const = default;
};

// The members that a step reads of most blocks come first and fill three cache lines.
struct alignas(64) ElementBlock {
  double length[kBlockSize];          // m
  double inverse_length[kBlockSize];  // 1/m
  std::int32_t base[4];          // by corner: first coordinate of the aligned run of eight that lanes read; -1: no run
  std::int32_t rotation[4];      // lane i reads base + (i + rotation) mod 8
  std::uint8_t odd[4];           // by corner: the few lanes, as bits, that read other coordinates than the run's
  std::int32_t section;          // row of the table of sections
  std::int32_t strain_partners;  // for Pairing::elsewhere: row of the table of strain partners
  bool variable;                 // whether the length of at least one lane changes
  Pairing pairing;
  bool whole;  // whether all corners read runs, also those of a pair's next block, and no strain partner is elsewhere
  alignas(64) double length_rate[kBlockSize];  // (dL/dt)/L, 1/s
  std::int32_t coordinate[4][kBlockSize];

  // Whether all lanes read the run of the corner.
  bool reads_run(int corner) const { return base[corner] >= 0 && odd[corner] == 0; }
  bool reads_runs() const { return reads_run(0) && reads_run(1) && reads_run(2) && reads_run(3); }
};

// Input of the element kernels.
struct BatchView {
  const ElementBlock* blocks;
  const SectionRows* sections;
  const ElementBlock* strain_partners;
};

// Powers summed over the computed elements, W.
struct BatchPower {
  double dissipated = 0;  // by internal damping
  double fed = 0;         // put into elements of variable length against their internal force
};

// Forces of a block of elements on their coordinates: nine rows of eight lanes. The force on r2 is minus that on r1 and
// not stored.
inline constexpr int kForceRows = 9;  // r1 x y z, g1 x y z, g2 x y z
// States of a block of elements: rows of eight lanes. Axial strain, its rate (1/s), bending energy (J), and what bends
// add to the axial stiffness (stable_step_as_bent).
inline constexpr int kStateRows = 4;
enum class Corner : std::uint8_t { position1 = 0, gradient1 = 1, position2 = 2, gradient2 = 3 };

class ElementBatch {
 public:
  explicit ElementBatch(std::span<const BatchElement> elements);

  BatchView view() const { return {blocks_.data(), sections_.data(), strain_partners_.data()}; }
  int block_count() const { return static_cast<int>(blocks_.size()); }
  int element_count() const { return element_count_; }
  const ElementBlock& block(int index) const { return blocks_[index]; }

  // Sets the material length (m) of a variable element and its rate (m/s).
  void set_length(int element, double length, double rate);

  // Writes the resisting forces Q (equation of motion: M qdd + Q = F) of blocks [first, last) at these coordinates and
  // velocities. `forces` holds kForceRows * kBlockSize doubles for each block of the batch, 64-byte aligned. The first
  // block of a pair (Pairing::first) writes the forces of both; the second is skipped. Safe to call from several
  // threads for different blocks.
  BatchPower forces(int first, int last, const CoordinateRows& coordinates, const CoordinateRows& velocities,
                    double* forces) const;
  // Writes the states of blocks [first, last). `states` holds kStateRows * kBlockSize doubles for each block of the
  // batch, 64-byte aligned. Safe to call from several threads for different blocks.
  void states(int first, int last, const CoordinateRows& coordinates, const CoordinateRows& velocities,
              double* states) const;

 private:
  std::int32_t index_of(const SectionRows& rows);
  void find_strain_partners(std::span<const BatchElement> elements);
  void find_whole();

  int element_count_ = 0;
  std::vector<ElementBlock> blocks_;
  std::vector<SectionRows> sections_;
  std::vector<ElementBlock>
      strain_partners_;  // for Pairing::elsewhere; lanes without a strain partner hold the element itself
};

}  // namespace netpocket
