#pragma once
// How far the writing of a run's frames is.

#include <chrono>
#include <cstddef>
#include <functional>

namespace netpocket {

struct RenderProgress {
  std::size_t done = 0;
  std::size_t total = 0;
  double seconds_left = 0;  // from the mean time of the frames so far
};
using RenderProgressCallback = std::function<void(const RenderProgress&)>;

enum class RenderOutcome { finished, cancelled };

// Reports to a callback, if there is one; the clock starts when it is made.
class ProgressMeter {
 public:
  ProgressMeter(std::size_t total, const RenderProgressCallback& callback) : total_(total), callback_(callback) {}

  void report(std::size_t done) const {
    if (!callback_) return;
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start_;
    callback_({done, total_, elapsed.count() / static_cast<double>(done) * static_cast<double>(total_ - done)});
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::size_t total_;
  const RenderProgressCallback& callback_;
};

}  // namespace netpocket
