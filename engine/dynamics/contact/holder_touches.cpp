#include "engine/dynamics/contact/holder_touches.h"

#include <algorithm>
#include <limits>
#include <span>

#include "engine/ancf/element_batch.h"
#include "engine/math/symmetric_algebra.h"

namespace netpocket {
namespace {

// Below the scores of places that touch, in the same order.
double score_apart(const WeightedPlace& place) {
  return -1 / (std::numeric_limits<double>::min() + std::max(place.score(), 0.0));
}

constexpr std::size_t index_of(int number) { return static_cast<std::size_t>(number); }

}  // namespace

HolderTouches::HolderTouches(ContactHolders holders, std::size_t parts, bool is_large_sphere)
    : holders_(std::move(holders)), is_large_sphere_(is_large_sphere), entry_(parts) {}

void HolderTouches::add(const Meeting& meeting, const ContactPart& part, const Eigen::Matrix3d& rotation) {
  part_ = &part;
  rotation_ = &rotation;
  for (int place = 0; place <= holders_.pieces(); ++place) {
    if (meeting.sums_contacts) {
      add_side(meeting, {place, place - 1, true});
      add_side(meeting, {place, place, false});
      continue;
    }
    const Candidate before = best_in_piece(meeting, place - 1, true);
    const Candidate behind = best_in_piece(meeting, place, false);
    const bool is_before = behind.segment < 0 || (before.segment >= 0 && before.score > behind.score);
    add_best(meeting, place, is_before ? before : behind);
  }
}

void HolderTouches::take(std::vector<CordTouch>& touches) {
  if (!is_large_sphere_) {
    const std::size_t found = touches_.size();
    add_vertices_at_holders();
    sort_by_block(found);
  }
  open_.clear();
  at_holders_.clear();
  for (const auto& [part, holder] : taken_) entry_[static_cast<std::size_t>(part)][holder] = -1;
  taken_.clear();
  std::swap(touches, touches_);
  touches_.clear();
}

// The capsule with the highest score in one piece of the element, for the holder at that piece's end or start.
HolderTouches::Candidate HolderTouches::best_in_piece(const Meeting& meeting, int piece, bool towards_end) const {
  Candidate best;
  if (piece < 0 || piece >= holders_.pieces()) return best;
  const int segments = holders_.capsules_of_a_piece();
  for (int i = 0; i < segments; ++i) {
    const int segment = piece * segments + i;
    const SegmentContact& contact = meeting.contacts[static_cast<std::size_t>(segment)];
    if (!contact.is_near) continue;
    const double from = static_cast<double>(i) / segments, to = static_cast<double>(i + 1) / segments;
    const PieceWeight weight = towards_end ? PieceWeight{from, to} : PieceWeight{1 - from, 1 - to};
    const double radius = meeting.radius;
    const double score = contact.distance < radius
                             ? estimate_deepest(contact, radius, weight).score()
                             : score_apart(estimate_deepest(contact, radius + meeting.ahead, weight));
    if (best.segment < 0 || score > best.score) best = {segment, weight, score};
  }
  return best;
}

void HolderTouches::add_best(const Meeting& meeting, int holder, const Candidate& candidate) {
  if (candidate.segment < 0) return;
  const auto segment = static_cast<std::size_t>(candidate.segment);
  const SegmentContact& contact = meeting.contacts[segment];
  const Segment piece{meeting.local[segment], meeting.local[segment + 1]};
  // A place that is still apart is judged as if the cord were thicker by `ahead`.
  const bool is_apart = contact.distance >= meeting.radius;
  const double thickness = is_apart ? meeting.radius + meeting.ahead : meeting.radius;
  // On a large sphere the parabola of the kernel is used, so that a search ahead changes nothing.
  const WeightedPlace estimate = estimate_deepest(contact, thickness, candidate.weight);
  const SegmentPlace place = !is_large_sphere_     ? find_deepest(*part_, piece, contact, thickness, candidate.weight)
                             : estimate.is_nearest ? contact.nearest
                                                   : place_on_segment(*part_, piece, estimate.t);
  const WeightedPlace found{place.t, candidate.weight.at(place.t), thickness - place.distance};
  if (!(found.weight > 0)) return;
  CordTouch* touch = claim(meeting, holder, is_apart ? score_apart(found) : found.score());
  if (touch == nullptr) return;
  touch->segment = candidate.segment;
  touch->t = place.t;
  touch->share = found.weight;
  touch->penetration = meeting.radius - place.distance;
  touch->normal = symmetric_product(*rotation_, place.normal);
  touch->point = meeting.world[segment] + place.t * (meeting.world[segment + 1] - meeting.world[segment]);
}

HolderTouches::Open& HolderTouches::open(std::int32_t part, std::size_t holder) {
  std::vector<std::int32_t>& of_part = entry_[static_cast<std::size_t>(part)];
  if (of_part.empty()) of_part.assign(holders_.count(), -1);
  if (of_part[holder] < 0) {
    of_part[holder] = static_cast<std::int32_t>(open_.size());
    open_.emplace_back();
    taken_.emplace_back(part, holder);
  }
  return open_[static_cast<std::size_t>(of_part[holder])];
}

// At a node, the side with the higher score bears the force. Returns the touch to be filled in, or null where the other
// side has a higher score.
CordTouch* HolderTouches::claim(const Meeting& meeting, int place, double score) {
  const std::size_t holder = holders_.index(meeting.element, place);
  Open& entry = open(meeting.part, holder);
  if (entry.best < 0) {
    entry.best = static_cast<std::int32_t>(touches_.size());
    CordTouch& added = touches_.emplace_back();
    added.first_element = meeting.element;
    added.first_place = place;
    added.part = meeting.part;
    added.holder = static_cast<std::int32_t>(holder);
  } else if (!(score > touches_[static_cast<std::size_t>(entry.best)].score)) {
    return nullptr;
  }
  CordTouch& touch = touches_[static_cast<std::size_t>(entry.best)];
  touch.element = meeting.element;
  touch.is_cord_end = holders_.is_cord_end(meeting.element, place);
  touch.score = score;
  return &touch;
}

void HolderTouches::add_side(const Meeting& meeting, const Side& side) {
  if (side.piece < 0 || side.piece >= holders_.pieces()) return;
  const int segments = holders_.capsules_of_a_piece(), first = side.piece * segments;
  bool touches_body = false;
  for (int segment = first; segment < first + segments; ++segment) {
    touches_body = touches_body || meeting.is_touching(segment);
  }
  if (touches_body) {
    add_vertices(meeting, side, add_capsules(meeting, side));
  } else {
    add_best(meeting, side.place, best_in_piece(meeting, side.piece, side.is_before));
  }
}

// A deepest place that is so close to a vertex counts as the vertex, which it would cancel.
HolderTouches::Ends HolderTouches::add_capsules(const Meeting& meeting, const Side& side) {
  constexpr double kAtVertex = 1e-6;  // of a capsule's length
  const int segments = holders_.capsules_of_a_piece(), first = side.piece * segments;
  const auto touches_at = [&](int vertex) {
    return meeting.vertices[index_of(first + vertex)].distance < meeting.radius;
  };
  Ends ends{};
  for (int i = 0; i < segments; ++i) {
    if (!meeting.is_touching(first + i)) continue;
    const std::size_t segment = index_of(first + i);
    const PieceWeight weight{holders_.weight_at(side.is_before, i), holders_.weight_at(side.is_before, i + 1)};
    const SegmentPlace& place = meeting.deepest[side.is_before ? 1 : 0][segment];
    if (place.t < kAtVertex && touches_at(i)) {
      ++ends[index_of(i)];
    } else if (place.t > 1 - kAtVertex && touches_at(i + 1)) {
      ++ends[index_of(i + 1)];
    } else {
      add_place(meeting, side, {first + i, place, weight.at(place.t), 1, 1 + i});
    }
  }
  return ends;
}

// The vertex at the holder itself waits for the other side (add_vertices_at_holders).
void HolderTouches::add_vertices(const Meeting& meeting, const Side& side, const Ends& ends) {
  const int segments = holders_.capsules_of_a_piece(), first = side.piece * segments,
            own = side.is_before ? segments : 0;
  const auto place_at = [&](int vertex) {
    const SurfacePoint& found = meeting.vertices[index_of(first + vertex)];
    return SegmentPlace{vertex == segments ? 1.0 : 0.0, found.distance, found.normal};
  };
  for (int i = 1; i < segments; ++i) {
    const SegmentPlace place = place_at(i);
    const int count = ends[index_of(i)] - 1;
    if (count == 0 || !(place.distance < meeting.radius)) continue;
    add_place(meeting, side,
              {first + i, place, holders_.weight_at(side.is_before, i), count, 1 + CordPolyline::kSegments + i});
  }
  const SegmentPlace at_holder = place_at(own);
  if (!(at_holder.distance < meeting.radius)) return;
  add_place(meeting, side, {side.is_before ? first + own - 1 : first, at_holder, 1, 0, 0});
  Open& entry = open(meeting.part, holders_.index(meeting.element, side.place));
  ++entry.sides;
  entry.ends += ends[index_of(own)];
}

void HolderTouches::add_place(const Meeting& meeting, const Side& side, const CountedPlace& counted) {
  const auto segment = static_cast<std::size_t>(counted.segment);
  const std::size_t holder = holders_.index(meeting.element, side.place);
  Open& entry = open(meeting.part, holder);
  const double depth = meeting.radius - counted.place.distance;
  const WeightedPlace found{counted.place.t, counted.weight, depth};
  CordTouch touch;
  touch.element = touch.first_element = meeting.element;
  touch.part = meeting.part;
  touch.holder = static_cast<std::int32_t>(holder);
  touch.segment = counted.segment;
  touch.first_place = (side.place * 2 + (side.is_before ? 0 : 1)) * 16 + counted.number;
  touch.t = counted.place.t;
  touch.share = counted.count * counted.weight;
  touch.penetration = depth;
  touch.is_cord_end = holders_.is_cord_end(meeting.element, side.place);
  touch.score = found.score();
  touch.normal = symmetric_product(*rotation_, counted.place.normal);
  touch.point = meeting.world[segment] + counted.place.t * (meeting.world[segment + 1] - meeting.world[segment]);
  if (counted.count == 0) {
    if (entry.at_holder < 0) {
      entry.at_holder = static_cast<std::int32_t>(at_holders_.size());
      at_holders_.push_back(touch);
    }
    return;
  }
  append(entry, touch);
}

// Appends a touch of a holder. A place that is still apart gives way to one that touches.
void HolderTouches::append(Open& entry, const CordTouch& touch) {
  CordTouch* best = entry.best < 0 ? nullptr : &touches_[static_cast<std::size_t>(entry.best)];
  if (best != nullptr && best->score < 0) {
    *best = touch;
    return;
  }
  const bool is_better = touch.share > 0 && (best == nullptr || !(best->share > 0) || touch.score > best->score);
  touches_.push_back(touch);
  CordTouch& added = touches_.back();
  if (entry.best < 0) {
    entry.best = static_cast<std::int32_t>(touches_.size()) - 1;
    return;
  }
  CordTouch& previous = touches_[static_cast<std::size_t>(entry.best)];
  added.is_extra = !is_better;
  previous.is_extra = is_better;
  if (is_better) entry.best = static_cast<std::int32_t>(touches_.size()) - 1;
}

// The vertex at a holder lies between its two sides.
void HolderTouches::add_vertices_at_holders() {
  for (Open& entry : open_) {
    if (entry.sides == 0) continue;
    const int count = entry.ends - (entry.sides - 1);
    if (count == 0) continue;
    CordTouch& at_holder = at_holders_[static_cast<std::size_t>(entry.at_holder)];
    at_holder.share = count;
    append(entry, at_holder);
  }
}

// The first `found` touches mostly are sorted already.
void HolderTouches::sort_by_block(std::size_t found) {
  const auto block_of = [](const CordTouch& touch) { return touch.first_element / kBlockSize; };
  const std::span all(touches_);
  for (const std::span part : {all.first(found), all.subspan(found)}) {
    if (!std::ranges::is_sorted(part, {}, block_of)) std::ranges::stable_sort(part, {}, block_of);
  }
  if (found == touches_.size()) return;
  sorted_.resize(touches_.size());
  std::ranges::merge(all.first(found), all.subspan(found), sorted_.begin(), {}, block_of, block_of);
  std::swap(touches_, sorted_);
}

}  // namespace netpocket
