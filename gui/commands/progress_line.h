#pragma once
// How far a long job is, on standard error: on a terminal one line that is redrawn, elsewhere a line every 10 %.

#include <chrono>
#include <string>

namespace netpocket {

class ProgressLine {
 public:
  explicit ProgressLine(bool shown);
  ~ProgressLine();  // leaves the terminal on a fresh line
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  // `fraction` of the job is done, 0 to 1.
  void update(double fraction, const std::string& text);

 private:
  using Clock = std::chrono::steady_clock;

  void redraw(double fraction, const std::string& text);
  void add_line(double fraction, const std::string& text);

  bool shown_;
  bool terminal_;
  bool drawn_ = false;
  Clock::time_point last_{};
  int tenths_ = 0;
};

// "9 s", "2 min 05 s", "1 h 03 min".
std::string duration_text(double seconds);

// What is left of a job of which `fraction` took `elapsed` seconds.
double seconds_left(double fraction, double elapsed);

}  // namespace netpocket
