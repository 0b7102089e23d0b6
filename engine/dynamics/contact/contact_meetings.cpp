#include "engine/dynamics/contact/contact_meetings.h"

#include <algorithm>
#include <limits>

namespace netpocket {
namespace {

constexpr auto kCapsules = static_cast<std::size_t>(CordPolyline::kSegments);

}  // namespace

double Meeting::clearance() const {
  double least = std::numeric_limits<double>::infinity();
  for (const SegmentContact& contact : contacts) least = std::min(least, contact.distance - radius);
  return least;
}

Meeting& ContactMeetings::append() {
  if (count_ == meetings_.size()) meetings_.emplace_back();
  return meetings_[count_++];
}

void ContactMeetings::measure(std::span<const ContactPart> parts, const ContactHolders& holders) {
  if (count_ == 0) return;
  const auto part_count = static_cast<std::int32_t>(parts.size());
  for (std::int32_t part = 0; part < part_count; ++part) {
    find_nearest_places(part, parts[static_cast<std::size_t>(part)]);
  }
  for (Meeting& meeting : all()) meeting.is_near = std::ranges::any_of(meeting.contacts, &SegmentContact::is_near);
  for (std::int32_t part = 0; part < part_count; ++part) {
    find_deepest_places(part, parts[static_cast<std::size_t>(part)], holders);
  }
}

void ContactMeetings::find_nearest_places(std::int32_t part, const ContactPart& solid) {
  point_tasks_.clear();
  nearest_tasks_.clear();
  for (Meeting& meeting : all()) {
    if (meeting.part != part) continue;
    for (std::size_t i = 0; i <= kCapsules; ++i) point_tasks_.push_back({&meeting.local[i], &meeting.vertices[i]});
    for (std::size_t i = 0; i < kCapsules; ++i) {
      nearest_tasks_.push_back({{meeting.local[i], meeting.local[i + 1]},
                                {&meeting.vertices[i], &meeting.vertices[i + 1]},
                                meeting.radius + meeting.ahead,
                                &meeting.contacts[i]});
    }
  }
  find_nearest_points(solid, point_tasks_);
  find_nearest(solid, nearest_tasks_);
}

// Each capsule counts for the holders at both ends of its piece of the element.
void ContactMeetings::find_deepest_places(std::int32_t part, const ContactPart& solid, const ContactHolders& holders) {
  deepest_tasks_.clear();
  for (Meeting& meeting : all()) {
    if (meeting.part != part || !meeting.is_near || !meeting.sums_contacts) continue;
    for (std::size_t i = 0; i < kCapsules; ++i) {
      const int segment = static_cast<int>(i), in_piece = segment % holders.capsules_of_a_piece();
      if (!meeting.is_touching(segment)) continue;
      for (const bool is_before : {false, true}) {
        const PieceWeight weight{holders.weight_at(is_before, in_piece), holders.weight_at(is_before, in_piece + 1)};
        deepest_tasks_.push_back({{meeting.local[i], meeting.local[i + 1]},
                                  &meeting.contacts[i],
                                  meeting.radius,
                                  weight,
                                  &meeting.deepest[is_before ? 1 : 0][i]});
      }
    }
  }
  find_deepest(solid, deepest_tasks_);
}

}  // namespace netpocket
