#pragma once
// The places where cords touch a large sphere, in blocks of eight elements. Internal to ContactSearch and
// ContactSolver.
//
// Elements that continue each other share the holder of contact at their node (contact_holders.h). The one whose place
// was found first has it, in the lane that this element has in its block. The other one's place replaces it if its
// score is higher. Mostly the eight lanes of a block continue in the same lanes of another block (the eight sectors),
// so whole rows are compared.
//
// Thread contract: one thread at a time.

#include <cstdint>
#include <span>
#include <vector>

#include "engine/base/aligned_vector.h"
#include "engine/dynamics/contact/sphere_kernel.h"

namespace netpocket {

// Touches at one holder of each of eight elements.
struct alignas(64) TouchBlock {
  TouchBlock() {}  // not defaulted: with that, all members would first be set to zero

  TouchRows rows;
  std::int32_t element[kBlockSize];  // the element that touches at the holder
  std::int32_t block, place;         // of the elements that were found first: block of elements, index of their holder
  std::uint32_t used;                // bit i: lane i holds a touch
};

class SphereTouches {
 public:
  static constexpr int kPlaces = 3;  // holders of an element: first node, middle, second node

  // `next`, `previous`: by element, the element that continues its cord, or -1.
  SphereTouches(std::span<const std::int32_t> next, std::span<const std::int32_t> previous);

  void clear();
  // Enters the places of the elements in `lanes` of a block that touch.
  void add(std::int32_t block, const sphere_kernel::SpherePlaces& places, std::uint32_t lanes);
  // In the order of add, then of places.
  std::span<const TouchBlock> blocks() const { return touches_; }

  // Index of the holder of each element of a block at `place`, and whether it is an end of the cord.
  const std::int32_t* holders(std::int32_t block, std::int32_t place) const {
    return holders_.data() + (block * kPlaces + place) * kBlockSize;
  }
  const std::uint8_t* are_cord_ends(std::int32_t block, std::int32_t place) const {
    return is_cord_end_.data() + (block * kPlaces + place) * kBlockSize;
  }

 private:
  std::int32_t twin_of(std::int32_t element, std::int32_t place) const;
  void find_twins(std::int32_t block, std::int32_t place);
  void add_place(std::int32_t block, std::int32_t place, const TouchRows& rows, std::uint32_t lanes);
  // Enters the lanes whose holders have been found already. Returns these.
  std::uint32_t share_block(TouchBlock& other, std::int32_t block, const TouchRows& rows, std::uint32_t lanes);
  std::uint32_t share_lanes(std::int32_t block, std::int32_t place, const TouchRows& rows, std::uint32_t lanes);

  std::vector<std::int32_t> next_, previous_;
  // By block of elements and place:
  std::vector<std::int32_t> twin_;  // the block whose lanes share the holders, or one of the values below
  static constexpr std::int32_t kNoTwin = -1, kScattered = -2;  // no lane does; lanes differ
  std::vector<std::int32_t> open_;                              // index into touches_, or -1
  std::vector<std::int32_t> holders_;                           // by lane
  std::vector<std::uint8_t> is_cord_end_;                       // by lane
  AlignedVector<TouchBlock> touches_;
};

}  // namespace netpocket
