#include "engine/dynamics/contact/spring_offsets.h"

#include <algorithm>
#include <limits>

#include "engine/contact/force_law.h"
#include "engine/math/elementary.h"

namespace netpocket {
namespace {

double energy_with(std::span<const ChangingSpring> springs, double offset) {
  double energy = 0;
  for (const ChangingSpring& s : springs) energy += s.share * elastic_energy({s.stiffness, 0}, s.depth - offset);
  return energy;
}

}  // namespace

// One spring stores 2/5 K s^2.5 at the compression s. With another stiffness K it stores the same at a compression in
// proportion to K^-0.4. The energy of several falls with their offset as long as together they push outwards.
double offset_of_same_energy(std::span<const ChangingSpring> springs) {
  double deepest = 0, energy = 0;
  for (const ChangingSpring& s : springs) {
    deepest = std::max(deepest, s.depth);
    energy += s.share * elastic_energy({s.stiffness_before, 0}, s.compression);
  }
  if (springs.size() == 1) {
    const double root = fifth_root(springs.front().stiffness_before / springs.front().stiffness);
    return std::clamp(springs.front().depth - root * root * springs.front().compression, 0.0, deepest);
  }
  double low = 0, high = deepest;
  if (energy_with(springs, low) <= energy) return low;
  constexpr int kHalvings = 60;  // to round-off
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (low + high);
    (energy_with(springs, middle) > energy ? low : high) = middle;
  }
  return high;
}

SpringOffsets::SpringOffsets(std::size_t parts, std::size_t holders)
    : offsets_(parts, std::vector<double>(holders, kApart)) {}

double SpringOffsets::follow(const Place& place, double depth, const std::array<std::int32_t, 2>& neighbours,
                             double entered) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  double offset = at(place);
  if (offset < 0) {
    double least = kNone;
    for (const std::int32_t neighbour : neighbours) {
      const double of_neighbour = neighbour < 0 ? kApart : at({place.first, neighbour});
      if (of_neighbour >= 0) least = std::min(least, of_neighbour);
    }
    offset = least < kNone ? least : depth - entered;
  }
  offset = std::clamp(offset, 0.0, std::max(depth, 0.0));
  followed_.emplace_back(place, offset);
  return offset;
}

void SpringOffsets::end_step() {
  set(followed_);
  followed_.clear();
}

void SpringOffsets::set(const std::vector<std::pair<Place, double>>& offsets) {
  clear();
  for (const auto& [place, offset] : offsets) {
    at(place) = offset;
    places_.push_back(place);
  }
  if (!has_offset()) clear();
}

void SpringOffsets::clear() {
  for (const Place& place : places_) at(place) = kApart;
  places_.clear();
}

void SpringOffsets::visit_state(const std::function<void(double&)>& visit) {
  places_.clear();
  for (std::size_t part = 0; part < offsets_.size(); ++part) {
    for (std::size_t holder = 0; holder < offsets_[part].size(); ++holder) {
      double& offset = offsets_[part][holder];
      visit(offset);
      if (!(offset >= 0)) offset = kApart;  // a file may hold a number that is not an offset
      if (offset >= 0) places_.emplace_back(part, holder);
    }
  }
  if (!has_offset()) clear();
}

}  // namespace netpocket
