#include "gui/workbench/simulation/run_pace.h"

namespace netpocket {
namespace {

using Seconds = std::chrono::duration<double>;

constexpr Seconds kSpeedWindow(0.5);
// A run that has fallen behind further than this does not try to catch up.
constexpr Seconds kLargestLag(0.2);

}  // namespace

void RunPace::note(double time, Clock::time_point now) {
  if (!window_) window_ = Mark{time, now};
  if (const Seconds elapsed = now - window_->wall; elapsed >= kSpeedWindow || (speed_ == 0 && elapsed.count() > 0.05)) {
    speed_ = (time - window_->time) / elapsed.count();
    if (elapsed >= kSpeedWindow) window_ = Mark{time, now};
  }
  due_.reset();
  if (rate_ <= 0) return;
  if (!start_) start_ = Mark{time, now};
  const auto due = start_->wall + std::chrono::duration_cast<Clock::duration>(Seconds((time - start_->time) / rate_));
  if (now - due > kLargestLag) {
    start_ = Mark{time, now};
  } else if (due > now) {
    due_ = due;
  }
}

}  // namespace netpocket
