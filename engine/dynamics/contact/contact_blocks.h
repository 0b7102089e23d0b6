#pragma once
// Contacts of cords with bodies in blocks of eight, and what these exert on coordinates and bodies. Internal to
// ContactSolver.
//
// A contact is in the lane of its element. The lanes of a block of elements mostly act on whole blocks of coordinates
// (the eight sectors). So most blocks of contacts are read and added without gathering.
//
// Order. Contacts of a coordinate come in the order of blocks, in every sector alike.

#include <bit>
#include <span>

#include "engine/ancf/element_batch.h"
#include "engine/base/aligned_vector.h"
#include "engine/dynamics/assembly/applied_forces.h"
#include "engine/dynamics/assembly/dynamic_body.h"
#include "engine/dynamics/contact/contact_kernel.h"
#include "engine/dynamics/contact/contact_search.h"
#include "engine/dynamics/contact/contacted_coordinates.h"

namespace netpocket {

// Calls function(lane) for each contact of a block.
template <typename Function>
void for_each_lane(const ContactBlock& block, const Function& function) {
  for (std::uint32_t left = block.used; left != 0; left &= left - 1) function(std::countr_zero(left));
}

// Appends blocks for touches whose first elements are in one block of elements: one for each place of the elements and
// part of the body, in this order. Returns the index of the first.
std::size_t open_blocks(std::span<const CordTouch> touches, std::int32_t body, AlignedVector<ContactBlock>& contacts);
// Sets what blocks know of the elements in their lanes: ContactBlock::is_regular, base, rotation and feeds.
void find_runs(const ElementBatch& batch, std::span<ContactBlock> contacts);
// Enters the contacts in `contacted`.
void share_inertia(std::span<ContactBlock> contacts, ContactedCoordinates& contacted);
// Adds the contacts' forces.
void add_to_coordinates(std::span<const ContactBlock> contacts, AppliedForces& applied);
// Sum of the contacts' forces on their body, about its centre of mass.
Wrench force_on_body(std::span<const ContactBlock> contacts, const Eigen::Vector3d& centre_of_mass);

}  // namespace netpocket
