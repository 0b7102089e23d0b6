#pragma once
// Times of frames as people and other programs read them.

#include <cmath>

namespace netpocket {

// A simulation's time is a sum of steps: 2.999999999999357 s stands for 3 s. To the nanosecond it is exact, and no step
// is that short.
inline double written_time(double time) {
  constexpr double kNanoseconds = 1e9;
  return std::abs(time) < 1e6 ? std::round(time * kNanoseconds) / kNanoseconds : time;
}

}  // namespace netpocket
