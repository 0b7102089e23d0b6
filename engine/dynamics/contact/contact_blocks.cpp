#include "engine/dynamics/contact/contact_blocks.h"

#include <algorithm>

#include "engine/math/instruction_set.h"
#include "engine/math/sector_sum.h"

namespace netpocket {
namespace {

using Eigen::Vector3d;

struct Kernels {
  contact_kernel::ShareKernel share;
  contact_kernel::ApplyKernel apply;
  contact_kernel::BodyKernel forces_on_body;
  sphere_kernel::PlacingKernel place;
};

const Kernels& kernels() {
  using namespace contact_kernel;
  static const Kernels chosen = {
      NETPOCKET_VARIANT_OF(contact_kernel, share), NETPOCKET_VARIANT_OF(contact_kernel, apply),
      NETPOCKET_VARIANT_OF(contact_kernel, forces_on_body), NETPOCKET_VARIANT_OF(sphere_kernel, place)};
  return chosen;
}

}  // namespace

namespace {

// Contacts of this many lanes or more are left in the lanes of their elements. Fewer are gathered.
constexpr std::ptrdiff_t kFullBlock = kBlockSize / 2;

// One of the touches of a block of elements.
struct OrderedTouch {
  std::int32_t part, place, lane;  // of its first element
  std::size_t index;               // among all touches
  auto operator<=>(const OrderedTouch&) const = default;
};

std::int32_t element_block(const CordTouch& touch) { return touch.first_element / kBlockSize; }

// The touches from `first` on that are of the same block of elements.
void put_in_order(std::span<const CordTouch> touches, std::size_t first, std::vector<OrderedTouch>& result) {
  result.clear();
  for (std::size_t i = first; i < touches.size() && element_block(touches[i]) == element_block(touches[first]); ++i) {
    result.push_back({touches[i].part, touches[i].first_place, touches[i].first_element % kBlockSize, i});
  }
  if (result.size() > 1) std::ranges::sort(result);
}

}  // namespace

void lay_out(std::span<const CordTouch> touches, std::int32_t body, ContactBlocks& contacts,
             std::vector<std::int32_t>& places) {
  const std::size_t first_place = places.size();
  places.resize(first_place + touches.size());
  const auto enter = [&](const OrderedTouch& touch, int lane) {
    const std::size_t block = contacts.size() - 1;
    contacts[block].used |= 1U << lane;
    contacts[block].body = body;
    places[first_place + touch.index] = static_cast<std::int32_t>(block) * kBlockSize + lane;
  };
  int next_lane = kBlockSize;  // of the last block; kBlockSize: it takes no more
  std::vector<OrderedTouch> ordered;
  for (std::size_t first = 0; first < touches.size();) {
    put_in_order(touches, first, ordered);
    first += ordered.size();
    for (auto alike = ordered.begin(); alike != ordered.end();) {
      const auto end = std::find_if(alike, ordered.end(), [&](const OrderedTouch& touch) {
        return touch.part != alike->part || touch.place != alike->place;
      });
      const bool is_full = end - alike >= kFullBlock;
      if (is_full) {
        contacts.append_empty();
        next_lane = kBlockSize;
      }
      for (; alike != end; ++alike) {
        if (!is_full && next_lane == kBlockSize) {
          contacts.append_empty();
          next_lane = 0;
        }
        enter(*alike, is_full ? alike->lane : next_lane++);
      }
    }
  }
}

namespace {

// The block of elements in whose lanes all touches are, each in the lane of its element; -1 if there is none.
std::int32_t common_block(const TouchBlock& touch) {
  const std::int32_t block = touch.element[std::countr_zero(touch.used)] / kBlockSize;
  for (int lane = 0; lane < kBlockSize; ++lane) {
    if ((touch.used >> lane & 1U) != 0 && touch.element[lane] != block * kBlockSize + lane) return -1;
  }
  return block;
}

// The place, of the elements in another block, at which they share the holder of `touch`.
std::int32_t place_of(const TouchBlock& touch, std::int32_t block) {
  return block == touch.block ? touch.place : SphereTouches::kPlaces - 1 - touch.place;
}

struct alignas(64) ElementRows {
  double length[kBlockSize];
  LawRows laws;
};

// Of touches of elements in several blocks.
void collect_elements(const TouchBlock& touch, const ContactSearch& search, double body_mass, const ElementBatch& batch,
                      ContactLaws& laws, ElementRows& rows, ContactBlock& contacts) {
  for (int lane = 0; lane < kBlockSize; ++lane) {
    const bool is_used = (touch.used >> lane & 1U) != 0;
    const std::int32_t element = is_used ? touch.element[lane] : touch.element[std::countr_zero(touch.used)];
    const std::int32_t block = element / kBlockSize, own = element % kBlockSize;
    const bool is_first = element == touch.block * kBlockSize + lane;
    const std::int32_t place = is_first ? touch.place : SphereTouches::kPlaces - 1 - touch.place;
    rows.length[lane] = batch.block(block).length[own];
    const LawRows& of_element = laws.of_block(block, place, search, body_mass);
    rows.laws.stiffness[lane] = of_element.stiffness[own];
    rows.laws.damping[lane] = of_element.damping[own];
    rows.laws.impact[lane] = of_element.impact[own];
    rows.laws.deepest[lane] = of_element.deepest[own];
    for (int corner = 0; corner < 4; ++corner) {
      contacts.coordinate[corner][lane] = batch.block(block).coordinate[corner][own];
    }
  }
}

}  // namespace

void place_touches(const TouchBlock& touch, std::int32_t body, const ContactSearch& search, double body_mass,
                   const ElementBatch& batch, ContactLaws& laws, ContactBlock& contacts) {
  contacts.body = body;
  contacts.used = touch.used;
  contacts.feeds = false;
  std::ranges::copy(touch.element, contacts.element);
  std::ranges::fill(contacts.part, 0);
  std::ranges::fill(contacts.is_extra, false);
  std::fill_n(&contacts.place[0][0], 4 * kBlockSize, 0);
  std::copy_n(search.sphere_touches().holders(touch.block, touch.place), kBlockSize, contacts.holder);
  std::copy_n(search.sphere_touches().are_cord_ends(touch.block, touch.place), kBlockSize, contacts.is_cord_end);
  const contact_kernel::Vertex* vertices = search.vertices().data();
  const std::int32_t block = common_block(touch);
  if (block >= 0) {
    const ElementBlock& elements = batch.block(block);
    std::copy_n(&elements.coordinate[0][0], 4 * kBlockSize, &contacts.coordinate[0][0]);
    kernels().place(touch.rows, touch.used, laws.of_block(block, place_of(touch, block), search, body_mass), vertices,
                    elements.length, contacts);
    return;
  }
  ElementRows rows;
  collect_elements(touch, search, body_mass, batch, laws, rows, contacts);
  kernels().place(touch.rows, touch.used, rows.laws, vertices, rows.length, contacts);
}

void find_runs(const ElementBatch& batch, std::span<ContactBlock> contacts) {
  for (ContactBlock& block : contacts) {
    const int elements = block.element[std::countr_zero(block.used)] / kBlockSize;
    const ElementBlock& of_elements = batch.block(elements);
    block.is_regular = of_elements.reads_runs();
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
