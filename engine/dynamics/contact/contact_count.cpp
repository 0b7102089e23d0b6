// The part of ContactSearch that enters places of contact where cords touch. Each capsule counts where it is deepest,
// and vertices that two capsules count are taken off (THEORY.md, section 6).

#include <algorithm>
#include <span>

#include "engine/dynamics/contact/contact_search.h"
#include "engine/math/symmetric_algebra.h"

namespace netpocket {

double ContactSearch::weight_at(bool is_before, int vertex) const {
  const double part = static_cast<double>(vertex * pieces_) / CordPolyline::kSegments;
  return is_before ? part : 1 - part;
}

bool ContactSearch::is_touching(const Meeting& meeting, int segment) const {
  const SegmentContact& contact = meeting.contacts[static_cast<std::size_t>(segment)];
  return contact.is_near && contact.distance < radius_[static_cast<std::size_t>(meeting.element)];
}

void ContactSearch::touch_side(const Meeting& meeting, const Side& side, std::vector<CordTouch>& touches) {
  if (side.piece < 0 || side.piece >= pieces_) return;
  const int segments = CordPolyline::kSegments / pieces_, first = side.piece * segments;
  bool touches_body = false;
  for (int segment = first; segment < first + segments; ++segment) {
    touches_body = touches_body || is_touching(meeting, segment);
  }
  if (touches_body) {
    add_vertices(meeting, side, add_capsules(meeting, side, touches), touches);
  } else {
    const double radius = radius_[static_cast<std::size_t>(meeting.element)];
    touch(meeting, side.holder, best_in_piece(meeting.contacts, radius, meeting.ahead, side.piece, side.is_before),
          touches);
  }
}

// A deepest place that is so close to a vertex counts as the vertex, which it would cancel.
ContactSearch::Ends ContactSearch::add_capsules(const Meeting& meeting, const Side& side,
                                                std::vector<CordTouch>& touches) {
  constexpr double kAtVertex = 1e-6;  // of a capsule's length
  const int segments = CordPolyline::kSegments / pieces_, first = side.piece * segments;
  const double radius = radius_[static_cast<std::size_t>(meeting.element)];
  const auto touches_at = [&](int vertex) {
    return meeting.vertices[static_cast<std::size_t>(first + vertex)].distance < radius;
  };
  Ends ends{};
  for (int i = 0; i < segments; ++i) {
    if (!is_touching(meeting, first + i)) continue;
    const auto segment = static_cast<std::size_t>(first + i);
    const PieceWeight weight{weight_at(side.is_before, i), weight_at(side.is_before, i + 1)};
    const SegmentPlace& place = meeting.deepest[side.is_before ? 1 : 0][segment];
    if (place.t < kAtVertex && touches_at(i)) {
      ++ends[static_cast<std::size_t>(i)];
    } else if (place.t > 1 - kAtVertex && touches_at(i + 1)) {
      ++ends[static_cast<std::size_t>(i + 1)];
    } else {
      add_place(meeting, side, {first + i, place, weight.at(place.t), 1, 1 + i}, touches);
    }
  }
  return ends;
}

// The vertex at the holder itself waits for the other side (finish_holders).
void ContactSearch::add_vertices(const Meeting& meeting, const Side& side, const Ends& ends,
                                 std::vector<CordTouch>& touches) {
  const int segments = CordPolyline::kSegments / pieces_, first = side.piece * segments,
            own = side.is_before ? segments : 0;
  const double radius = radius_[static_cast<std::size_t>(meeting.element)];
  const auto place_at = [&](int vertex) {
    const SurfacePoint& found = meeting.vertices[static_cast<std::size_t>(first + vertex)];
    return SegmentPlace{vertex == segments ? 1.0 : 0.0, found.distance, found.normal};
  };
  for (int i = 1; i < segments; ++i) {
    const SegmentPlace place = place_at(i);
    const int count = ends[static_cast<std::size_t>(i)] - 1;
    if (count == 0 || !(place.distance < radius)) continue;
    add_place(meeting, side, {first + i, place, weight_at(side.is_before, i), count, 1 + CordPolyline::kSegments + i},
              touches);
  }
  const SegmentPlace at_holder = place_at(own);
  if (!(at_holder.distance < radius)) return;
  add_place(meeting, side, {side.is_before ? first + own - 1 : first, at_holder, 1, 0, 0}, touches);
  Open& open = open_[static_cast<std::size_t>(
      holder_touch_[static_cast<std::size_t>(meeting.part)][holder_index(meeting.element, side.holder)])];
  ++open.sides;
  open.ends += ends[static_cast<std::size_t>(own)];
}

void ContactSearch::add_place(const Meeting& meeting, const Side& side, const CountedPlace& counted,
                              std::vector<CordTouch>& touches) {
  const auto element = static_cast<std::size_t>(meeting.element), segment = static_cast<std::size_t>(counted.segment);
  const std::size_t holder = holder_index(meeting.element, side.holder);
  std::vector<std::int32_t>& of_part = holder_touch_[static_cast<std::size_t>(meeting.part)];
  if (of_part.empty()) of_part.assign(holder_count(), -1);
  if (of_part[holder] < 0) {
    of_part[holder] = static_cast<std::int32_t>(open_.size());
    open_.emplace_back();
    taken_.emplace_back(meeting.part, holder);
  }
  Open& open = open_[static_cast<std::size_t>(of_part[holder])];
  const double depth = radius_[element] - counted.place.distance;
  const WeightedPlace found{counted.place.t, counted.weight, depth};
  CordTouch touch;
  touch.element = touch.first_element = meeting.element;
  touch.part = meeting.part;
  touch.holder = static_cast<std::int32_t>(holder);
  touch.segment = counted.segment;
  touch.first_place = (side.holder * 2 + (side.is_before ? 0 : 1)) * 16 + counted.number;
  touch.t = counted.place.t;
  touch.share = counted.count * counted.weight;
  touch.penetration = depth;
  touch.is_cord_end = (side.holder == 0 && previous_[element] < 0) || (side.holder == pieces_ && next_[element] < 0);
  touch.score = found.score();
  touch.normal = symmetric_product(meeting.body->rigid().rotation(), counted.place.normal);
  touch.point = meeting.world[segment] + counted.place.t * (meeting.world[segment + 1] - meeting.world[segment]);
  if (counted.count == 0) {
    if (open.at_holder < 0) {
      open.at_holder = static_cast<std::int32_t>(at_holders_.size());
      at_holders_.push_back(touch);
    }
    return;
  }
  append(open, touch, touches);
}

// Appends a touch of a holder. A place that is still apart gives way to one that touches.
void ContactSearch::append(Open& open, const CordTouch& touch, std::vector<CordTouch>& touches) {
  CordTouch* best = open.best < 0 ? nullptr : &touches[static_cast<std::size_t>(open.best)];
  if (best != nullptr && best->score < 0) {
    *best = touch;
    return;
  }
  const bool is_better = touch.share > 0 && (best == nullptr || !(best->share > 0) || touch.score > best->score);
  touches.push_back(touch);
  CordTouch& added = touches.back();
  if (open.best < 0) {
    open.best = static_cast<std::int32_t>(touches.size()) - 1;
    return;
  }
  CordTouch& previous = touches[static_cast<std::size_t>(open.best)];
  added.is_extra = !is_better;
  previous.is_extra = is_better;
  if (is_better) open.best = static_cast<std::int32_t>(touches.size()) - 1;
}

// The vertex at a holder lies between its two sides.
void ContactSearch::finish_holders(std::vector<CordTouch>& touches) {
  const std::size_t found = touches.size();
  for (Open& open : open_) {
    if (open.sides == 0) continue;
    const int count = open.ends - (open.sides - 1);
    if (count == 0) continue;
    CordTouch& at_holder = at_holders_[static_cast<std::size_t>(open.at_holder)];
    at_holder.share = count;
    append(open, at_holder, touches);
  }
  sort_by_block(touches, found);
}

// Touches of elements that are computed together come together. The first `found` mostly do so already.
void ContactSearch::sort_by_block(std::vector<CordTouch>& touches, std::size_t found) {
  const auto block_of = [](const CordTouch& touch) { return touch.first_element / kBlockSize; };
  const std::span all(touches);
  for (const std::span part : {all.first(found), all.subspan(found)}) {
    if (!std::ranges::is_sorted(part, {}, block_of)) std::ranges::stable_sort(part, {}, block_of);
  }
  if (found == touches.size()) return;
  sorted_.resize(touches.size());
  std::ranges::merge(all.first(found), all.subspan(found), sorted_.begin(), {}, block_of, block_of);
  std::swap(touches, sorted_);
}

}  // namespace netpocket
