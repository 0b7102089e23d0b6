#pragma once
// Internal forces of many mean-strain cable elements at once: the fast form of mean_strain_element.h, tested against it
// to round-off. Elements are computed in blocks of eight lanes; consecutive elements whose coordinates are consecutive
// too (the eight sectors of a pocket) are read without gathering.
//
// A "coordinate" is one vector-valued coordinate: a node's position or a gradient.

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "engine/ancf/cable_section.h"

namespace netpocket {

inline constexpr int kBlockSize = 8;  // elements (and coordinates) computed at once

// Where the vectors of all coordinates stand: of every block of eight coordinates a row of eight x, one of y and one of
// z, 64-byte aligned.
struct CoordinateRows {
  const double* first = nullptr;
};
inline constexpr int kVectorRows = 3;

struct BatchElement {
  std::int32_t coordinate[4];  // r1, g1, r2, g2
  double length;               // m
  CableSection section;
  bool variable = false;             // length changes during the run: see set_length
  std::int32_t strain_partner = -1;  // element with which it shares its axial strain (strain_pair.h), or -1
};

// How the elements of a block find their strain partners' strain.
enum class Pairing : std::uint8_t {
  none,      // no element has a strain partner
  first,     // the strain partner of each lane is the same lane of the next block
  second,    // ... of the previous block
  elsewhere  // anywhere: the block has a copy of what its strain partners read
};

// What the elements of a block are made of, by lane. Few differ: blocks refer to a common table that stays in the
// fastest cache.
struct alignas(64) SectionRows {
  double axial_stiffness[kBlockSize];        // EA, N
  double compression_stiffness[kBlockSize];  // EA in compression, N
  double axial_damping[kBlockSize];          // c, s
  double bending_rigidity[kBlockSize];       // EI, N m^2
  double bending_damping[kBlockSize];        // c, s

  bool operator==(const SectionRows&) const = default;
};

// What a step reads of most blocks comes first: three cache lines.
struct alignas(64) ElementBlock {
  double length[kBlockSize];          // m
  double inverse_length[kBlockSize];  // 1/m
  std::int32_t base[4];  // by corner: first coordinate of an aligned run of eight that the lanes read rotated, or -1
  std::int32_t rotation[4];      // lane i reads base + (i + rotation) mod 8
  std::int32_t section;          // row of the table of sections
  std::int32_t strain_partners;  // pairing elsewhere: row of the table of strain partners
  bool variable;                 // the length of a lane or more changes
  Pairing pairing;
  alignas(64) double length_rate[kBlockSize];  // Ldot/L, 1/s
  std::int32_t coordinate[4][kBlockSize];
};

// What the element kernels read.
struct BatchView {
  const ElementBlock* blocks;
  const SectionRows* sections;
  const ElementBlock* strain_partners;
};

// W.
struct BatchPower {
  double dissipated = 0;  // by internal damping
  double fed = 0;         // put into elements of variable length against their internal force
};

// Forces of one element on its coordinates, by block: nine rows of eight lanes. The force on r2 is minus that on r1.
inline constexpr int kForceRows = 9;  // r1 x y z, g1 x y z, g2 x y z
// State of one element, by block: rows of eight lanes.
// Axial strain, its rate (1/s), bending energy (J), what bends add to the stiffness of stretching
// (stable_step_as_bent).
inline constexpr int kStateRows = 4;
enum class Corner : std::uint8_t { position1 = 0, gradient1 = 1, position2 = 2, gradient2 = 3 };

class ElementBatch {
 public:
  explicit ElementBatch(std::span<const BatchElement> elements);

  BatchView view() const { return {blocks_.data(), sections_.data(), strain_partners_.data()}; }
  int block_count() const { return static_cast<int>(blocks_.size()); }
  int element_count() const { return element_count_; }
  const ElementBlock& block(int index) const { return blocks_[index]; }

  // Material length of a variable element and its rate (m, m/s).
  void set_length(int element, double length, double rate);

  // Resisting forces Q (equation of motion: M qdd + Q = F) of blocks [first, last) at these coordinates and velocities.
  // `forces` holds kForceRows * kBlockSize doubles for each block of the batch, 64-byte aligned. A pair of blocks
  // counts as its first. Safe to call from several threads for different blocks.
  BatchPower forces(int first, int last, const CoordinateRows& coordinates, const CoordinateRows& velocities,
                    double* forces) const;
  // Strains and energies of blocks [first, last): `states` holds kStateRows * kBlockSize doubles for each block of the
  // batch, 64-byte aligned. Likewise safe.
  void states(int first, int last, const CoordinateRows& coordinates, const CoordinateRows& velocities,
              double* states) const;

 private:
  std::int32_t index_of(const SectionRows& rows);
  void find_strain_partners(std::span<const BatchElement> elements);

  int element_count_ = 0;
  std::vector<ElementBlock> blocks_;
  std::vector<SectionRows> sections_;
  std::vector<ElementBlock>
      strain_partners_;  // of blocks with pairing elsewhere; lanes without a strain partner hold the element itself
};

}  // namespace netpocket
