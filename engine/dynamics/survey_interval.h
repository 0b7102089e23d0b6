#pragma once
// How often to look for what may touch before long: seldom where steps are small, but before anything travels so far
// that margins must be wide.

#include <algorithm>

namespace netpocket {

// Steps until the next survey if a point may travel `travel_per_step` (m) in each, and no more than `longest_travel`.
inline int survey_interval(double travel_per_step, double longest_travel) {
  constexpr int kUsual = 16, kLongest = 128;
  constexpr double kCheapTravel = 0.01;  // m, that widens margins little
  const auto steps_to = [&](double travel, int least, int most) {
    if (!(travel_per_step * most > travel)) return most;  // nor where the state is lost
    return std::max(least, static_cast<int>(travel / travel_per_step));
  };
  const int steps = steps_to(std::min(kCheapTravel, longest_travel), kUsual, kLongest);
  return steps_to(longest_travel, 1, steps);
}

}  // namespace netpocket
