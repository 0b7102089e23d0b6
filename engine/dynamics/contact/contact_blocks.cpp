#include "engine/dynamics/contact/contact_blocks.h"

#include <algorithm>
#include <utility>

#include "engine/math/instruction_set.h"
#include "engine/math/sector_sum.h"

namespace netpocket {
namespace {

using Eigen::Vector3d;

struct Kernels {
  contact_kernel::ShareKernel share;
  contact_kernel::ApplyKernel apply;
  contact_kernel::BodyKernel forces_on_body;
};

const Kernels& kernels() {
  using namespace contact_kernel;
  static const Kernels chosen = {NETPOCKET_VARIANT_OF(contact_kernel, share),
                                 NETPOCKET_VARIANT_OF(contact_kernel, apply),
                                 NETPOCKET_VARIANT_OF(contact_kernel, forces_on_body)};
  return chosen;
}

}  // namespace

std::size_t open_blocks(std::span<const CordTouch> touches, std::int32_t body, AlignedVector<ContactBlock>& contacts) {
  const std::size_t first = contacts.size();
  for (const CordTouch& touch : touches) {
    const auto comes_before = [&](const ContactBlock& block) {
      return std::pair(block.first_part, block.first_place) < std::pair(touch.part, touch.first_place);
    };
    auto place = contacts.begin() + static_cast<std::ptrdiff_t>(first);
    while (place != contacts.end() && comes_before(*place)) ++place;
    if (place != contacts.end() && place->first_part == touch.part && place->first_place == touch.first_place) continue;
    ContactBlock& block = *contacts.emplace(place);
    block.body = body;
    block.first_part = touch.part;
    block.first_place = touch.first_place;
  }
  return first;
}

void find_runs(const ElementBatch& batch, std::span<ContactBlock> contacts) {
  for (ContactBlock& block : contacts) {
    const int elements = block.element[std::countr_zero(block.used)] / kBlockSize;
    const ElementBlock& of_elements = batch.block(elements);
    block.is_regular = std::ranges::all_of(of_elements.base, [](std::int32_t base) { return base >= 0; });
    for_each_lane(block, [&](int lane) {
      block.is_regular = block.is_regular && block.element[lane] == elements * kBlockSize + lane;
      block.feeds = block.feeds || batch.block(block.element[lane] / kBlockSize).variable;
    });
    std::ranges::copy(of_elements.base, block.base);
    std::ranges::copy(of_elements.rotation, block.rotation);
  }
}

void share_inertia(std::span<ContactBlock> contacts, ContactedCoordinates& contacted) {
  for (ContactBlock& block : contacts) {
    for (std::size_t corner = 0; corner < 4; ++corner) {
      if (block.is_regular) {
        std::ranges::fill(block.place[corner], contacted.place_for(block.base[corner]));
      } else {
        for_each_lane(
            block, [&](int lane) { block.place[corner][lane] = contacted.place_for(block.coordinate[corner][lane]); });
      }
    }
  }
  kernels().share(contacts.data(), contacts.size(), contacted.shared_weights());
}

void add_to_coordinates(std::span<const ContactBlock> contacts, AppliedForces& applied) {
  for (const ContactBlock& block : contacts) {
    for (std::size_t corner = 0; corner < 4; ++corner) {
      if (block.is_regular) {
        applied.touch(block.base[corner]);
      } else {
        for_each_lane(block, [&](int lane) { applied.touch(block.coordinate[corner][lane]); });
      }
    }
  }
  kernels().apply(contacts.data(), contacts.size(), applied.data());
}

// Contacts of regular blocks are in the lanes of their elements' sectors.
Wrench force_on_body(std::span<const ContactBlock> contacts, const Vector3d& centre_of_mass) {
  SectorSum<Vector3d> force(Vector3d::Zero()), torque(Vector3d::Zero());
  if (std::ranges::all_of(contacts, &ContactBlock::is_regular)) {
    contact_kernel::BodyForces sums;
    kernels().forces_on_body(contacts.data(), contacts.size(), centre_of_mass.data(), sums);
    for (int lane = 0; lane < kBlockSize; ++lane) {
      force.add(lane, lane_of(sums.force, lane));
      torque.add(lane, lane_of(sums.torque, lane));
    }
    return {force.total(), torque.total()};
  }
  for (const ContactBlock& block : contacts) {
    for_each_lane(block, [&](int lane) {
      const Vector3d on_body = -lane_of(block.force, lane);
      force.add(block.element[lane], on_body);
      torque.add(block.element[lane], (lane_of(block.point, lane) - centre_of_mass).cross(on_body));
    });
  }
  return {force.total(), torque.total()};
}

}  // namespace netpocket
