#pragma once
// Loops whose work several threads may share. The caller of a function passes the loop to it.

#include <algorithm>
#include <functional>
#include <vector>

namespace netpocket {

// Calls work(first, last) for ranges that together cover [0, count), possibly several at the same time. Returns when
// all calls have returned. Ranges begin at multiples of `grain`. `work` must not throw.
using DividedLoop = std::function<void(int count, int grain, const std::function<void(int first, int last)>& work)>;

// A DividedLoop in which the caller does all the work.
inline void undivided_loop(int count, int /*grain*/, const std::function<void(int first, int last)>& work) {
  work(0, count);
}

// Divides [0, count) into ranges of `grain` (the last may be shorter) and returns value(first, last) of each, in their
// order. The result does not depend on the threads that share the loop.
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

// The same with find(first, last, found), which appends to `found`: returns the joined lists of all ranges, in their
// order.
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
