#include "engine/dynamics/contact/sphere_touches.h"

#include <algorithm>
#include <bit>

namespace netpocket {
namespace {

constexpr std::uint32_t kAllLanes = (1U << kBlockSize) - 1;

template <typename Function>
void for_each_lane_of(std::uint32_t lanes, const Function& function) {
  for (; lanes != 0; lanes &= lanes - 1) function(std::countr_zero(lanes));
}

void copy_lane(const TouchRows& from, int lane, TouchRows& to, int to_lane) {
  to.depth[to_lane] = from.depth[lane];
  to.share[to_lane] = from.share[lane];
  to.score[to_lane] = from.score[lane];
  to.segment[to_lane] = from.segment[lane];
  to.t[to_lane] = from.t[lane];
  for (int axis = 0; axis < 3; ++axis) {
    to.point[axis][to_lane] = from.point[axis][lane];
    to.normal[axis][to_lane] = from.normal[axis][lane];
  }
}

}  // namespace

SphereTouches::SphereTouches(std::span<const std::int32_t> next, std::span<const std::int32_t> previous)
    : next_(next.begin(), next.end()), previous_(previous.begin(), previous.end()) {
  const std::size_t blocks = (next.size() + kBlockSize - 1) / kBlockSize;
  twin_.assign(blocks * kPlaces, kNoTwin);
  open_.assign(blocks * kPlaces, -1);
  holders_.assign(blocks * kPlaces * kBlockSize, 0);
  is_cord_end_.assign(blocks * kPlaces * kBlockSize, 0);
  for (std::size_t block = 0; block < blocks; ++block) {
    for (std::int32_t place = 0; place < kPlaces; ++place) find_twins(static_cast<std::int32_t>(block), place);
  }
}

// The element that shares the holder of an element at a place, or -1.
std::int32_t SphereTouches::twin_of(std::int32_t element, std::int32_t place) const {
  if (place == 0) return previous_[static_cast<std::size_t>(element)];
  return place == kPlaces - 1 ? next_[static_cast<std::size_t>(element)] : -1;
}

void SphereTouches::find_twins(std::int32_t block, std::int32_t place) {
  const auto index = static_cast<std::size_t>(block * kPlaces + place);
  const std::int32_t first = block * kBlockSize;
  const std::int32_t lanes = std::min(kBlockSize, static_cast<std::int32_t>(next_.size()) - first);
  const std::int32_t twin = twin_of(first, place);
  twin_[index] = twin < 0 ? kNoTwin : twin / kBlockSize;
  for (std::int32_t lane = 0; lane < lanes; ++lane) {
    const std::int32_t element = first + lane, other = twin_of(element, place);
    const bool fits = twin < 0 ? other < 0 : other == twin / kBlockSize * kBlockSize + lane;
    if (!fits) twin_[index] = kScattered;
    const std::size_t entry = index * kBlockSize + static_cast<std::size_t>(lane);
    const bool is_of_next = place == kPlaces - 1 && other >= 0;
    holders_[entry] = is_of_next ? other * kPlaces : element * kPlaces + place;
    is_cord_end_[entry] = place != 1 && other < 0 ? 1 : 0;
  }
}

void SphereTouches::clear() {
  for (const TouchBlock& touch : touches_) open_[static_cast<std::size_t>(touch.block * kPlaces + touch.place)] = -1;
  touches_.clear();
}

void SphereTouches::add(std::int32_t block, const sphere_kernel::SpherePlaces& places, std::uint32_t lanes) {
  for (std::int32_t place = 0; place < kPlaces; ++place) {
    const TouchRows& rows = places.holder[place];
    std::uint32_t touching = 0;
    for_each_lane_of(lanes, [&](int lane) {
      if (rows.depth[lane] > 0 && rows.share[lane] > 0) touching |= 1U << lane;
    });
    if (touching != 0) add_place(block, place, rows, touching);
  }
}

void SphereTouches::add_place(std::int32_t block, std::int32_t place, const TouchRows& rows, std::uint32_t lanes) {
  const auto index = static_cast<std::size_t>(block * kPlaces + place);
  const std::int32_t twin = twin_[index];
  std::uint32_t shared = 0;
  if (twin == kScattered) {
    shared = share_lanes(block, place, rows, lanes);
  } else if (twin >= 0) {
    const std::int32_t open = open_[static_cast<std::size_t>(twin * kPlaces + kPlaces - 1 - place)];
    if (open >= 0) shared = share_block(touches_[static_cast<std::size_t>(open)], block, rows, lanes);
  }
  const std::uint32_t left = lanes & ~shared;
  if (left == 0) return;
  open_[index] = static_cast<std::int32_t>(touches_.size());
  TouchBlock& touch = touches_.emplace_back();
  touch.rows = rows;
  for (int lane = 0; lane < kBlockSize; ++lane) touch.element[lane] = block * kBlockSize + lane;
  touch.block = block;
  touch.place = place;
  touch.used = left;
}

std::uint32_t SphereTouches::share_block(TouchBlock& other, std::int32_t block, const TouchRows& rows,
                                         std::uint32_t lanes) {
  const std::uint32_t shared = lanes & other.used;
  std::uint32_t better = 0;
  for (int lane = 0; lane < kBlockSize; ++lane) {
    better |= static_cast<std::uint32_t>(rows.score[lane] > other.rows.score[lane]) << lane;
  }
  better &= shared;
  if (better == kAllLanes) {
    other.rows = rows;
    for (int lane = 0; lane < kBlockSize; ++lane) other.element[lane] = block * kBlockSize + lane;
    return shared;
  }
  for_each_lane_of(better, [&](int lane) {
    copy_lane(rows, lane, other.rows, lane);
    other.element[lane] = block * kBlockSize + lane;
  });
  return shared;
}

std::uint32_t SphereTouches::share_lanes(std::int32_t block, std::int32_t place, const TouchRows& rows,
                                         std::uint32_t lanes) {
  std::uint32_t shared = 0;
  for_each_lane_of(lanes, [&](int lane) {
    const std::int32_t element = block * kBlockSize + lane, twin = twin_of(element, place);
    if (twin < 0) return;
    const std::int32_t open = open_[static_cast<std::size_t>(twin / kBlockSize * kPlaces + kPlaces - 1 - place)];
    const int other_lane = twin % kBlockSize;
    if (open < 0 || (touches_[static_cast<std::size_t>(open)].used >> other_lane & 1U) == 0) return;
    shared |= 1U << lane;
    TouchBlock& other = touches_[static_cast<std::size_t>(open)];
    if (!(rows.score[lane] > other.rows.score[other_lane])) return;
    copy_lane(rows, lane, other.rows, other_lane);
    other.element[other_lane] = element;
  });
  return shared;
}

}  // namespace netpocket
