#include "engine/dynamics/contact/contact_holders.h"

#include "engine/dynamics/contact/cord_chain.h"
#include "engine/dynamics/contact/cord_polyline.h"

namespace netpocket {

ContactHolders::ContactHolders(std::span<const std::int32_t> next, int pieces)
    : next_(next.begin(), next.end()), previous_(netpocket::previous_elements(next_)), pieces_(pieces) {}

int ContactHolders::capsules_of_a_piece() const { return CordPolyline::kSegments / pieces_; }

// An element owns the holders at its first node and inside it, and at its second node only where its cord ends.
std::size_t ContactHolders::index(std::int32_t element, int place) const {
  const std::size_t holders = static_cast<std::size_t>(pieces_) + 1;
  const std::int32_t next = next_[static_cast<std::size_t>(element)];
  if (place == pieces_ && next >= 0) return static_cast<std::size_t>(next) * holders;
  return static_cast<std::size_t>(element) * holders + static_cast<std::size_t>(place);
}

bool ContactHolders::is_cord_end(std::int32_t element, int place) const {
  const auto i = static_cast<std::size_t>(element);
  return (place == 0 && previous_[i] < 0) || (place == pieces_ && next_[i] < 0);
}

std::array<std::int32_t, 2> ContactHolders::neighbours(std::int32_t holder) const {
  const std::int32_t element = holder / (pieces_ + 1), place = holder % (pieces_ + 1);
  const std::int32_t previous = previous_[static_cast<std::size_t>(element)];
  const std::int32_t before = place > 0 ? holder - 1 : previous >= 0 ? previous * (pieces_ + 1) + pieces_ - 1 : -1;
  const std::int32_t behind = place < pieces_ ? static_cast<std::int32_t>(index(element, place + 1)) : -1;
  return {before, behind};
}

double ContactHolders::weight_at(bool is_before, int vertex) const {
  const double part = static_cast<double>(vertex * pieces_) / CordPolyline::kSegments;
  return is_before ? part : 1 - part;
}

}  // namespace netpocket
