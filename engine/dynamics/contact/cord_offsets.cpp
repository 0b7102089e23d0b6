#include "engine/dynamics/contact/cord_offsets.h"

#include <algorithm>
#include <limits>

namespace netpocket {

const CordOffsets::Contact* CordOffsets::find(const Place& place) const {
  const auto found = std::ranges::lower_bound(contacts_, place, {}, &Contact::place);
  return found != contacts_.end() && found->place == place ? &*found : nullptr;
}

double CordOffsets::follow(const Capsule& one, const Capsule& other, double depth, double entered) const {
  const auto at_most_the_depth = [depth](double offset) { return std::min(offset, std::max(depth, 0.0)); };
  if (const Contact* same = find(place_of(one, other))) return at_most_the_depth(same->offset);
  constexpr double kNone = std::numeric_limits<double>::infinity();
  double least = kNone;
  for (const std::int32_t a : {one.before, one.number, one.after}) {
    for (const std::int32_t b : {other.before, other.number, other.after}) {
      const Contact* neighbour = find({std::min(a, b), std::max(a, b)});
      if (neighbour != nullptr) least = std::min(least, neighbour->offset);
    }
  }
  return at_most_the_depth(least < kNone ? least : std::max(depth - entered, 0.0));
}

void CordOffsets::end_step() { std::ranges::sort(contacts_, {}, &Contact::place); }

// A file may hold numbers that are none of a state.
void CordOffsets::visit_state(const std::function<void(double&)>& visit) {
  constexpr double kMost = 1e6;
  auto count = static_cast<double>(contacts_.size());
  visit(count);
  contacts_.resize(count >= 0 && count <= kMost ? static_cast<std::size_t>(count) : 0);
  const auto visit_number = [&](std::int32_t& number) {
    double value = number;
    visit(value);
    number = value >= 0 && value <= std::numeric_limits<std::int32_t>::max() ? static_cast<std::int32_t>(value) : 0;
  };
  for (Contact& contact : contacts_) {
    visit_number(contact.place.first);
    visit_number(contact.place.second);
    visit(contact.offset);
    if (!(contact.offset >= 0)) contact.offset = 0;
  }
  end_step();
}

}  // namespace netpocket
