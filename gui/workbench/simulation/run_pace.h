#pragma once
// How fast a run goes and how fast it should go, as simulated seconds for one second of wall time.

#include <chrono>
#include <optional>

namespace netpocket {

class RunPace {
 public:
  using Clock = std::chrono::steady_clock;

  // 0: as fast as possible.
  void set_rate(double rate) {
    rate_ = rate;
    start_.reset();
  }
  // To be called when the run goes on after a pause, at simulated time `time` (s).
  void restart(double time, Clock::time_point now) {
    start_ = Mark{time, now};
    window_ = start_;
    speed_ = 0;
  }
  // To be called with each frame.
  void note(double time, Clock::time_point now);

  // Lately; 0 when not known yet.
  double speed() const { return speed_; }
  // When the next frame is due; none when at once.
  std::optional<Clock::time_point> due() const { return due_; }

 private:
  struct Mark {
    double time;  // s, simulated
    Clock::time_point wall;
  };

  double rate_ = 0;
  double speed_ = 0;
  std::optional<Mark> start_;   // from which the due time is counted
  std::optional<Mark> window_;  // from which the speed is counted
  std::optional<Clock::time_point> due_;
};

}  // namespace netpocket
