#include "gui/workbench/timeline/playback.h"

#include <algorithm>

namespace netpocket {
namespace {

constexpr int kInterval = 25;  // ms between pictures

}  // namespace

Playback::Playback(QObject* parent) : QObject(parent) {
  timer_.setInterval(kInterval);
  timer_.setTimerType(Qt::PreciseTimer);
  connect(&timer_, &QTimer::timeout, this, &Playback::tick);
}

void Playback::set_range(double begin, double end) {
  begin_ = begin;
  end_ = end;
}

void Playback::set_time(double time) { time_ = std::clamp(time, begin_, std::max(begin_, end_)); }

void Playback::play(int direction) {
  if (end_ <= begin_) return;
  direction_ = direction;
  // From the end, playing starts over.
  if (direction > 0 && time_ >= end_) time_ = begin_;
  if (direction < 0 && time_ <= begin_) time_ = end_;
  clock_.start();
  timer_.start();
  emit time_reached(time_);
  emit playing_changed();
}

void Playback::stop() {
  if (!timer_.isActive()) return;
  timer_.stop();
  emit playing_changed();
}

void Playback::tick() {
  const double elapsed = 1e-3 * static_cast<double>(clock_.restart());
  time_ = limited(time_ + direction_ * speed_ * elapsed);
  emit time_reached(time_);
}

double Playback::limited(double time) {
  if (time >= begin_ && time <= end_) return time;
  const bool at_end = time > end_;
  if (loop_) return at_end ? begin_ : end_;
  stop();
  return at_end ? end_ : begin_;
}

}  // namespace netpocket
