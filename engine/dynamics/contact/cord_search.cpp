#include "engine/dynamics/contact/cord_search.h"

#include <algorithm>
#include <cmath>

#include "engine/contact/near_pairs.h"
#include "engine/dynamics/assembly/element_curve.h"
#include "engine/math/block_size.h"
#include "engine/math/symmetric_algebra.h"

namespace netpocket {
namespace {

using Eigen::AlignedBox3d;
using Eigen::Vector3d;

// Number of steps for which the list of near capsules should last at the last step's motion, and the largest motion (m)
// that its margin allows for.
constexpr double kUsualSteps = 32, kLongestTravel = 0.01;
// Candidates are grouped. A group is skipped while none of its candidates can be within reach.
constexpr std::size_t kGroup = 64;
// Elements or pairs that a thread processes as one piece.
constexpr int kElementRange = 1024;
// Smallest reach (m): capsules nearer than this are tested at every step.
constexpr double kLeastReach = 0.01;
// Upper limit of the reach as a fraction of broad_margin(), for fine nets in which everything would be near.
constexpr double kNearPart = 0.25;
// broad_margin() by the elements' mean length, so that the number of candidates per element does not depend on the
// mesh.
constexpr double kBroadMargin = 0.45;

// The middle control points of the Bezier form of an element's cubic less the points of its chord at 1/3 and 2/3. The
// curve is off the chord by no more than 3/4 of the longer of the two: 3t(1-t)^2 + 3t^2(1-t) <= 3/4.
struct Sag {
  Vector3d first, second;
};

Sag sag(const Vector3d& chord, const Vector3d& gradient1, const Vector3d& gradient2, double length) {
  return {(length * gradient1 - chord) / 3, (chord - length * gradient2) / 3};
}

double margin_of_candidates(const Model& model) {
  if (model.elements.empty()) return kBroadMargin;
  double length = 0;
  for (const ModelElement& element : model.elements) length += element.length;
  return kBroadMargin * length / static_cast<double>(model.elements.size());
}

}  // namespace

CordSearch::CordSearch(const Model& model, const CordPolyline& polyline, const CordPairs& pairs)
    : model_(model),
      polyline_(polyline),
      pairs_(pairs),
      motion_(model),
      broad_margin_(margin_of_candidates(model)),
      near_place_(model.elements.size(), -1) {}

// In a diverged state the distances are not numbers, so they are reset as well.
void CordSearch::forget() {
  travelled_ = last_way_ = 0;
  has_candidates_ = is_fresh_ = false;
}

void CordSearch::note_way(double way) {
  travelled_ += way;
  displaced_ += way;
  last_way_ = way;
}

bool CordSearch::find_candidates(const CoordinateVectors& coordinates, const std::vector<double>& element_length,
                                 const DividedLoop& loop) {
  std::vector<AlignedBox3d> boxes(model_.elements.size());
  loop(static_cast<int>(boxes.size()), kElementRange, [&](int first, int last) {
    for (std::int32_t i = first; i < last; ++i) {
      const auto index = static_cast<std::size_t>(i);
      boxes[index] = curve_bounds(coordinates, polyline_.indices(i), element_length[index], model_.radius_of(i));
    }
  });
  if (!std::ranges::all_of(boxes, is_sound)) return false;
  const auto pairs = near_pairs(boxes, broad_margin_, loop);
  candidates_ = found_in_ranges<Candidate>(
      loop, static_cast<int>(pairs.size()), kElementRange, [&](int from, int to, std::vector<Candidate>& found) {
        for (auto i = static_cast<std::size_t>(from); i < static_cast<std::size_t>(to); ++i) {
          const auto [first, second] = pairs[i];
          if (!pairs_.may_touch(first, second)) continue;
          if (least_gap(coordinates, element_length, first, second) > broad_margin_) continue;
          found.push_back({first, second, 0});
        }
      });
  group_clear_until_.assign((candidates_.size() + kGroup - 1) / kGroup, 0.0);
  has_candidates_ = true;
  travelled_ = displaced_ = 0;
  candidate_coordinates_ = coordinates;
  candidate_lengths_ = element_length;
  return true;
}

double CordSearch::least_gap(const CoordinateVectors& coordinates, const std::vector<double>& element_length,
                             std::int32_t first, std::int32_t second) const {
  double sags = 0;
  const auto chord = [&](std::int32_t element) {
    const auto& coordinate = polyline_.indices(element);
    const Segment segment{coordinates.get(coordinate[0]), coordinates.get(coordinate[2])};
    const auto [one, other] = sag(segment.end - segment.start, coordinates.get(coordinate[1]),
                                  coordinates.get(coordinate[3]), element_length[static_cast<std::size_t>(element)]);
    sags += 0.75 * std::sqrt(std::max(one.squaredNorm(), other.squaredNorm()));
    return segment;
  };
  const Segment a = chord(first), b = chord(second);
  const double thickness = model_.radius_of(first) + model_.radius_of(second);
  return closest_points(a, b).distance - sags - thickness;
}

std::int32_t CordSearch::near_index(std::int32_t element) {
  std::int32_t& place = near_place_[static_cast<std::size_t>(element)];
  if (place < 0) {
    place = static_cast<std::int32_t>(near_elements_.size());
    near_elements_.push_back(element);
  }
  return place;
}

void CordSearch::add_near_segments(const CoordinateVectors& coordinates, const std::vector<double>& element_length,
                                   const Candidate& candidate, double reach) {
  const auto a_index = static_cast<std::size_t>(candidate.first), b_index = static_cast<std::size_t>(candidate.second);
  const auto a = polyline_.vertices(coordinates, element_length[a_index], candidate.first);
  const auto b = polyline_.vertices(coordinates, element_length[b_index], candidate.second);
  const double near = reach + model_.radius_of(candidate.first) + model_.radius_of(candidate.second);
  for (std::size_t i = 0; i < CordPolyline::kSegments; ++i) {
    for (std::size_t j = 0; j < CordPolyline::kSegments; ++j) {
      if (closest_points({a[i], a[i + 1]}, {b[j], b[j + 1]}).distance > near) continue;
      near_.push_back({near_index(candidate.first), near_index(candidate.second), static_cast<std::int32_t>(i),
                       static_cast<std::int32_t>(j)});
    }
  }
}

void CordSearch::look_at(Candidate& candidate, const CoordinateVectors& coordinates,
                         const std::vector<double>& element_length, double reach) {
  if (2 * (candidate.clear_until - travelled_) > reach) return;
  const double gap = least_gap(coordinates, element_length, candidate.first, candidate.second);
  candidate.clear_until = travelled_ + 0.5 * gap;
  if (gap < reach) add_near_segments(coordinates, element_length, candidate, reach);
}

// Whether the candidates contain all pairs within `reach`. Pairs outside the list were farther apart than the margin
// when it was made, and have approached by at most twice the largest displacement since. The path length is an upper
// bound of that displacement. Where cords vibrate it is much larger, so the displacement itself is measured when the
// bound fails.
bool CordSearch::has_candidates_for(double reach, const CoordinateVectors& coordinates,
                                    const std::vector<double>& element_length, const DividedLoop& loop) {
  const auto suffices = [&] { return 2 * displaced_ + reach <= broad_margin_; };
  if (!has_candidates_) return false;
  if (suffices()) return true;
  double longer = 0;
  for (std::size_t i = 0; i < element_length.size(); ++i) {
    longer = std::max(longer, std::abs(element_length[i] - candidate_lengths_[i]));
  }
  displaced_ = motion_.way(candidate_coordinates_, coordinates, loop) + 0.25 * longer;
  constexpr double kLeastInHand = 0.1;  // fraction of the margin; with less, the list would be checked again at once
  return 2 * displaced_ + reach <= (1 - kLeastInHand) * broad_margin_;
}

void CordSearch::refresh(const CoordinateVectors& coordinates, const std::vector<double>& element_length, double ahead,
                         const DividedLoop& loop) {
  for (const std::int32_t element : near_elements_) near_place_[static_cast<std::size_t>(element)] = -1;
  near_elements_.clear();
  near_.clear();
  const double expected = 2 * std::min(kUsualSteps * last_way_, std::min(kLongestTravel, kNearPart * broad_margin_));
  reach_ = std::min(kLeastReach, kNearPart * broad_margin_) + expected + ahead;
  if (!has_candidates_for(reach_, coordinates, element_length, loop)) {
    if (!find_candidates(coordinates, element_length, loop)) {
      candidates_.clear();
      group_clear_until_.clear();
      forget();
      sides_.clear();
      return;
    }
    reach_ = std::min(reach_, broad_margin_);
  }
  for (std::size_t group = 0; group < group_clear_until_.size(); ++group) {
    if (2 * (group_clear_until_[group] - travelled_) > reach_) continue;
    double first = std::numeric_limits<double>::infinity();
    for (std::size_t i = group * kGroup; i < std::min(candidates_.size(), (group + 1) * kGroup); ++i) {
      look_at(candidates_[i], coordinates, element_length, reach_);
      first = std::min(first, candidates_[i].clear_until);
    }
    group_clear_until_[group] = first;
  }
  sort_sides();
  travelled_at_refresh_ = travelled_;
  is_fresh_ = true;
}

// Sides by keys of 64 bits, in this order of weight: own element locally (27 bits) and the other one (27), sectors
// between them (3), segments (2 each), own sector (3).
void CordSearch::sort_sides() {
  static_assert(kSectors <= 8 && CordPolyline::kSegments <= 4);
  keyed_sides_.clear();
  for (std::size_t i = 0; i < near_.size(); ++i) {
    const NearSegments& pair = near_[i];
    std::int32_t own = near_elements_[static_cast<std::size_t>(pair.first)], own_segment = pair.first_segment;
    std::int32_t other = near_elements_[static_cast<std::size_t>(pair.second)], other_segment = pair.second_segment;
    for (const bool second : {false, true}) {
      std::uint64_t key = 0;
      const auto append = [&](std::int32_t value, int bits) { key = key << bits | static_cast<std::uint64_t>(value); };
      append(own / kSectors, 27);
      append(other / kSectors, 27);
      append((other % kSectors - own % kSectors + kSectors) % kSectors, 3);
      append(own_segment, 2);
      append(other_segment, 2);
      append(own % kSectors, 3);
      keyed_sides_.emplace_back(key, NearSide{static_cast<std::int32_t>(i), second});
      std::swap(own, other);
      std::swap(own_segment, other_segment);
    }
  }
  std::ranges::sort(keyed_sides_, {}, [](const auto& keyed) { return keyed.first; });
  sides_.clear();
  for (const auto& [key, side] : keyed_sides_) sides_.push_back(side);
}

// Capsules outside the list were farther apart than reach_ when it was made, and have approached by at most twice the
// path length since.
void CordSearch::update(const CoordinateVectors& coordinates, const std::vector<double>& element_length, double ahead,
                        const DividedLoop& loop) {
  if (is_due(ahead)) refresh(coordinates, element_length, ahead, loop);
}

}  // namespace netpocket
