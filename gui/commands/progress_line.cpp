#include "gui/commands/progress_line.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>

namespace netpocket {

ProgressLine::ProgressLine(bool shown) : shown_(shown), terminal_(isatty(STDERR_FILENO) == 1) {}

ProgressLine::~ProgressLine() {
  if (drawn_) std::fputc('\n', stderr);
}

void ProgressLine::update(double fraction, const std::string& text) {
  if (!shown_) return;
  if (terminal_) {
    redraw(fraction, text);
  } else {
    add_line(fraction, text);
  }
}

void ProgressLine::redraw(double fraction, const std::string& text) {
  constexpr auto kInterval = std::chrono::milliseconds(100);
  const auto now = Clock::now();
  if (drawn_ && fraction < 1 && now - last_ < kInterval) return;
  last_ = now;
  drawn_ = true;
  std::fputs(fmt::format("\r\033[K{:3.0f} %  {}", 100 * fraction, text).c_str(), stderr);
  std::fflush(stderr);
}

void ProgressLine::add_line(double fraction, const std::string& text) {
  constexpr double kRounding = 1e-9;
  const int tenths = static_cast<int>(std::floor(10 * fraction + kRounding));
  if (tenths <= tenths_) return;
  tenths_ = tenths;
  std::fputs(fmt::format("{:3d} %  {}\n", 10 * tenths, text).c_str(), stderr);
}

std::string duration_text(double seconds) {
  const auto whole = std::llround(seconds);
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {:02d} s", whole / 60, whole % 60);
  return fmt::format("{} h {:02d} min", whole / 3600, whole % 3600 / 60);
}

double seconds_left(double fraction, double elapsed) { return fraction > 0 ? elapsed * (1 - fraction) / fraction : 0; }

}  // namespace netpocket
