#pragma once
// Contacts of cords with bodies in blocks of eight, and what these exert on coordinates and bodies. Internal to
// ContactSolver.
//
// Where eight sectors touch a body alike, a contact is in the lane of its element. The lanes of a block of elements
// mostly act on whole blocks of coordinates (the eight sectors). So these blocks of contacts are read and added without
// gathering. Contacts that are not alike fill the lanes of blocks one after the other.
//
// Order. Contacts of a coordinate come in the order of blocks and lanes, in every sector alike.

#include <bit>
#include <span>
#include <vector>

#include "engine/ancf/element_batch.h"
#include "engine/base/aligned_vector.h"
#include "engine/dynamics/assembly/applied_forces.h"
#include "engine/dynamics/assembly/dynamic_body.h"
#include "engine/dynamics/contact/contact_kernel.h"
#include "engine/dynamics/contact/contact_laws.h"
#include "engine/dynamics/contact/contact_search.h"
#include "engine/dynamics/contact/contacted_coordinates.h"

namespace netpocket {

// Calls function(lane) for each contact of a block.
template <typename Function>
void for_each_lane(const ContactBlock& block, const Function& function) {
  for (std::uint32_t left = block.used; left != 0; left &= left - 1) function(std::countr_zero(left));
}

// Blocks of contacts. Keeps its memory between steps, because most of a block's rows are set anew anyway.
class ContactBlocks {
 public:
  void clear() { count_ = 0; }
  std::size_t size() const { return count_; }
  ContactBlock& operator[](std::size_t index) { return blocks_[index]; }
  const ContactBlock& operator[](std::size_t index) const { return blocks_[index]; }
  std::span<ContactBlock> from(std::size_t first) { return std::span(blocks_.data(), count_).subspan(first); }
  std::span<ContactBlock> range(std::size_t first, std::size_t last) {
    return {blocks_.data() + first, blocks_.data() + last};
  }
  std::span<const ContactBlock> range(std::size_t first, std::size_t last) const {
    return {blocks_.data() + first, blocks_.data() + last};
  }

  // Adds a block at the end, which has any content.
  ContactBlock& append() {
    if (count_ == blocks_.size()) blocks_.emplace_back();
    return blocks_[count_++];
  }
  // Adds a block without contacts at the end, all zero.
  ContactBlock& append_empty() { return append() = ContactBlock{}; }

 private:
  AlignedVector<ContactBlock> blocks_;
  std::size_t count_ = 0;
};

// Appends blocks for the touches of a body, which are ordered by the block of their first element, and for each touch
// its place to `places`: block * kBlockSize + lane. Places of the elements of a block come by part of the body and by
// CordTouch::first_place.
void lay_out(std::span<const CordTouch> touches, std::int32_t body, ContactBlocks& contacts,
             std::vector<std::int32_t>& places);
// Sets all that a touch determines, for contacts with a body of one part and springs that begin at the surface.
// `search` is the one that found it.
void place_touches(const TouchBlock& touch, std::int32_t body, const ContactSearch& search, double body_mass,
                   const ElementBatch& batch, ContactLaws& laws, ContactBlock& contacts);
// Sets what blocks know of the elements in their lanes: ContactBlock::is_regular, base, rotation and feeds.
void find_runs(const ElementBatch& batch, std::span<ContactBlock> contacts);
// Enters the contacts in `contacted`.
void share_inertia(std::span<ContactBlock> contacts, ContactedCoordinates& contacted);
// Adds the contacts' forces.
void add_to_coordinates(std::span<const ContactBlock> contacts, AppliedForces& applied);
// Sum of the contacts' forces on their body, about its centre of mass.
Wrench force_on_body(std::span<const ContactBlock> contacts, const Eigen::Vector3d& centre_of_mass);

}  // namespace netpocket
