#pragma once
// Loops that the caller of a function may have several threads share.

#include <algorithm>
#include <functional>
#include <vector>

namespace netpocket {

// Calls work(first, last) with ranges that make up [0, count), perhaps some at the same time, and returns when all have
// returned. They begin at multiples of `grain`. `work` must not throw.
using DividedLoop = std::function<void(int count, int grain, const std::function<void(int first, int last)>& work)>;

inline void undivided_loop(int count, int /*grain*/, const std::function<void(int first, int last)>& work) {
  work(0, count);
}

// What value(first, last) is for each range of `grain` (the last may be shorter) of [0, count), in their order: the
// same whatever threads share the loop.
template <typename Value, typename Function>
std::vector<Value> values_of_ranges(const DividedLoop& loop, int count, int grain, const Function& value) {
  const int ranges = (count + grain - 1) / grain;
  std::vector<Value> values(static_cast<std::size_t>(ranges));
  loop(ranges, 1, [&](int first, int last) {
    for (int i = first; i < last; ++i) {
      values[static_cast<std::size_t>(i)] = value(i * grain, std::min(count, (i + 1) * grain));
    }
  });
  return values;
}

// What find(first, last, found) appends to `found` for all such ranges, in their order.
template <typename Found, typename Function>
std::vector<Found> found_in_ranges(const DividedLoop& loop, int count, int grain, const Function& find) {
  const auto parts = values_of_ranges<std::vector<Found>>(loop, count, grain, [&](int first, int last) {
    std::vector<Found> found;
    find(first, last, found);
    return found;
  });
  std::size_t size = 0;
  for (const std::vector<Found>& part : parts) size += part.size();
  std::vector<Found> all;
  all.reserve(size);
  for (const std::vector<Found>& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

}  // namespace netpocket
