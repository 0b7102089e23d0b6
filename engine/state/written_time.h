#pragma once
// Times of frames, rounded for people and other programs.

#include <cmath>

namespace netpocket {

// Rounds a time (s) to nanoseconds. The time of a simulation is a sum of steps, so that 2.999999999999357 s stands for
// 3 s. To the nanosecond the sum is exact, and no step is that short. Times of 1e6 s and more are not rounded.
inline double written_time(double time) {
  constexpr double kNanoseconds = 1e9;
  return std::abs(time) < 1e6 ? std::round(time * kNanoseconds) / kNanoseconds : time;
}

}  // namespace netpocket
