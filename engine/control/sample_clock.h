#pragma once
// The sampling times of something with a rate: multiples of its period. A look that is late skips what it missed.

#include <cstdint>

#include "engine/control/visited_numbers.h"

namespace netpocket {

class SampleClock {
 public:
  explicit SampleClock(double rate) : rate_(rate) {}  // Hz, positive

  double period() const { return 1 / rate_; }  // s
  // Whether a sample is due at `time` (s), which must not fall. It then counts as taken.
  bool take(double time) {
    constexpr double kEarly = 1e-6;  // part of a period by which round-off of the time may make a sample early
    if (time * rate_ < static_cast<double>(next_) - kEarly) return false;
    next_ = static_cast<std::uint64_t>(time * rate_ + kEarly) + 1;
    return true;
  }

  void visit_state(const NumberVisitor& visit) { visit_count(visit, next_); }

 private:
  double rate_;
  std::uint64_t next_ = 0;  // the next sample is due at next_/rate
};

}  // namespace netpocket
