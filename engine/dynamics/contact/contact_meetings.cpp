// The part of ContactSearch that measures elements near the body: their capsules side by side, all of one part of the
// body together (segment_batch.h).

#include <algorithm>
#include <limits>

#include "engine/dynamics/contact/contact_search.h"

namespace netpocket {
namespace {

constexpr auto kCapsules = static_cast<std::size_t>(CordPolyline::kSegments);

// Cords that may pass more than this part of a solid's thickness in a step are to be stopped. Each holder then has only
// the place where it is deepest.
constexpr double kFastWay = 0.5;

}  // namespace

bool ContactSearch::sums_contacts(const Meeting& meeting) const {
  return !is_large_sphere_ && meeting.ahead <= kFastWay * parts_[static_cast<std::size_t>(meeting.part)].thickness;
}

void ContactSearch::find_nearest_places(std::int32_t part) {
  const ContactPart& solid = parts_[static_cast<std::size_t>(part)];
  point_tasks_.clear();
  nearest_tasks_.clear();
  for (Meeting& meeting : meetings()) {
    if (meeting.part != part) continue;
    const double reach = radius_[static_cast<std::size_t>(meeting.element)] + meeting.ahead;
    for (std::size_t i = 0; i <= kCapsules; ++i) point_tasks_.push_back({&meeting.local[i], &meeting.vertices[i]});
    for (std::size_t i = 0; i < kCapsules; ++i) {
      nearest_tasks_.push_back({{meeting.local[i], meeting.local[i + 1]},
                                {&meeting.vertices[i], &meeting.vertices[i + 1]},
                                reach,
                                &meeting.contacts[i]});
    }
  }
  find_nearest_points(solid, point_tasks_);
  find_nearest(solid, nearest_tasks_);
}

// Each capsule counts for the holders at both ends of its piece of the element.
void ContactSearch::find_deepest_places(std::int32_t part) {
  deepest_tasks_.clear();
  for (Meeting& meeting : meetings()) {
    if (meeting.part != part || !meeting.is_near || !sums_contacts(meeting)) continue;
    const double radius = radius_[static_cast<std::size_t>(meeting.element)];
    for (std::size_t i = 0; i < kCapsules; ++i) {
      const int segment = static_cast<int>(i), in_piece = segment % (CordPolyline::kSegments / pieces_);
      if (!is_touching(meeting, segment)) continue;
      for (const bool is_before : {false, true}) {
        const PieceWeight weight{weight_at(is_before, in_piece), weight_at(is_before, in_piece + 1)};
        deepest_tasks_.push_back({{meeting.local[i], meeting.local[i + 1]},
                                  &meeting.contacts[i],
                                  radius,
                                  weight,
                                  &meeting.deepest[is_before ? 1 : 0][i]});
      }
    }
  }
  find_deepest(parts_[static_cast<std::size_t>(part)], deepest_tasks_);
}

void ContactSearch::measure_meetings(std::vector<CordTouch>& touches) {
  const auto parts = static_cast<std::int32_t>(meeting_count_ > 0 ? parts_.size() : 0);
  for (std::int32_t part = 0; part < parts; ++part) find_nearest_places(part);
  for (Meeting& meeting : meetings()) {
    const double radius = radius_[static_cast<std::size_t>(meeting.element)];
    double least = std::numeric_limits<double>::infinity();
    meeting.is_near = false;
    for (const SegmentContact& contact : meeting.contacts) {
      least = std::min(least, contact.distance - radius);
      meeting.is_near = meeting.is_near || contact.is_near;
    }
    note_clearance(meeting.element, least);
  }
  for (std::int32_t part = 0; part < parts; ++part) find_deepest_places(part);
  for (const Meeting& meeting : meetings()) {
    if (meeting.is_near) add_touches_of(meeting, touches);
  }
  meeting_count_ = 0;
}

void ContactSearch::add_touches_of(const Meeting& meeting, std::vector<CordTouch>& touches) {
  const double radius = radius_[static_cast<std::size_t>(meeting.element)];
  for (int holder = 0; holder <= pieces_; ++holder) {
    if (sums_contacts(meeting)) {
      touch_side(meeting, {holder, holder - 1, true}, touches);
      touch_side(meeting, {holder, holder, false}, touches);
      continue;
    }
    const Candidate before = best_in_piece(meeting.contacts, radius, meeting.ahead, holder - 1, true);
    const Candidate behind = best_in_piece(meeting.contacts, radius, meeting.ahead, holder, false);
    const bool is_before = behind.segment < 0 || (before.segment >= 0 && before.score > behind.score);
    touch(meeting, holder, is_before ? before : behind, touches);
  }
}

}  // namespace netpocket
