#include "engine/dynamics/contact/spring_offsets.h"

#include <algorithm>

namespace netpocket {

SpringOffsets::SpringOffsets(std::size_t parts, std::size_t holders)
    : offsets_(parts, std::vector<double>(holders, 0.0)) {}

double SpringOffsets::follow(const Place& place, double depth) {
  if (places_.empty()) return 0;
  double& offset = at(place);
  return offset = std::min(offset, std::max(depth, 0.0));
}

void SpringOffsets::set(const Place& place, double offset) {
  double& present = at(place);
  if (present == 0 && offset > 0) places_.push_back(place);
  present = offset;
}

void SpringOffsets::keep_only(std::vector<Place> present) {
  if (places_.empty()) return;
  std::ranges::sort(present);
  std::erase_if(places_, [&](const Place& place) {
    double& offset = at(place);
    if (!std::ranges::binary_search(present, place)) offset = 0;
    return offset == 0;
  });
}

void SpringOffsets::clear() {
  for (const Place& place : places_) at(place) = 0;
  places_.clear();
}

void SpringOffsets::visit_state(const std::function<void(double&)>& visit) {
  places_.clear();
  for (std::size_t part = 0; part < offsets_.size(); ++part) {
    for (std::size_t holder = 0; holder < offsets_[part].size(); ++holder) {
      double& offset = offsets_[part][holder];
      visit(offset);
      if (!(offset >= 0)) offset = 0;  // a file may hold a number that is not an offset
      if (offset > 0) places_.emplace_back(part, holder);
    }
  }
}

}  // namespace netpocket
