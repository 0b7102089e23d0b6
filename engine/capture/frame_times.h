#pragma once
// When a run takes its frames: at t = 0, every 1/frame_rate after it and at the end time.

#include <cmath>
#include <cstdint>

#include "engine/scenario/scenario.h"

namespace netpocket {

// Times of the frames after the first: multiples of the output interval, and the end time.
class FrameTimes {
 public:
  explicit FrameTimes(const OutputParameters& output)
      : output_(output),
        count_(static_cast<std::int64_t>(std::ceil(output.end_time * output.frame_rate - kRounding))) {}

  std::int64_t count() const { return count_; }
  double at(std::int64_t index) const {
    return index < count_ ? static_cast<double>(index) / output_.frame_rate : output_.end_time;
  }
  // Index of the first frame after a time (s).
  std::int64_t after(double time) const {
    return static_cast<std::int64_t>(std::floor(time * output_.frame_rate + kRounding)) + 1;
  }
  // Whether a frame lies at a multiple of the output interval. The last one may not.
  bool is_whole(std::int64_t index) const {
    return index < count_ || std::abs(output_.end_time * output_.frame_rate - static_cast<double>(count_)) < kRounding;
  }

  // Tolerance, as a fraction of an output interval, for rounding errors in products and sums of times.
  static constexpr double kRounding = 1e-6;

 private:
  OutputParameters output_;
  std::int64_t count_;
};

}  // namespace netpocket
