#include "engine/control/closing_control.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace netpocket {
namespace {

// Faster winding is named as the likely cause of a divergence. Ten times what a closing within 5 s needs.
constexpr double kFastWinding = 30;  // m/s

RopeMotion motion_of(const ClosingState& state) { return {state.length, state.speed, state.acceleration}; }

}  // namespace

ClosingControl::ClosingControl(const ClosingParameters& closing, const std::vector<double>& open_lengths,
                               std::shared_ptr<const CaptureTimes> times)
    : closing_(closing), open_lengths_(open_lengths), times_(std::move(times)) {
  if (times_) closing_.start = times_->closing_start;
  make_schedules();
  motions_.resize(schedules_.size());
}

void ClosingControl::make_schedules() {
  schedules_.clear();
  schedule_of_rope_.clear();
  for (const double open : open_lengths_) {
    const auto known = std::ranges::find(schedules_, open, &ClosingSchedule::open_length);
    schedule_of_rope_.push_back(static_cast<std::size_t>(known - schedules_.begin()));
    if (known == schedules_.end()) schedules_.emplace_back(closing_, open);
  }
}

void ClosingControl::follow_start() {
  if (!times_ || times_->closing_start == closing_.start) return;
  closing_.start = times_->closing_start;
  make_schedules();
  if (changed_ >= 0) follow_changed_law();
}

RopeMotion ClosingControl::motion(std::size_t rope, double time) const {
  return motion_of(transition_ ? transition_->at(time) : schedules_[schedule_of_rope_[rope]].at(time));
}

void ClosingControl::update(const Measurements& measurements, double interval, Commands& commands) {
  follow_start();
  const double end = measurements.time() + interval;
  for (std::size_t i = 0; i < schedules_.size(); ++i) {
    motions_[i] = motion_of(transition_ ? transition_->at(end) : schedules_[i].at(end));
    fastest_ = std::max(fastest_, std::abs(motions_[i].rate));
  }
  for (std::size_t rope = 0; rope < schedule_of_rope_.size(); ++rope) {
    commands.wind(static_cast<std::int32_t>(rope), motions_[schedule_of_rope_[rope]]);
  }
}

void ClosingControl::change(const Scenario& scenario, double now) {
  ClosingParameters next = scenario.closing;
  if (times_) next.start = times_->closing_start;
  if (next == closing_) return;
  const RopeMotion present = motion(0, now);
  closing_ = next;
  at_change_ = {present.length, present.rate, present.acceleration};
  changed_ = now;
  follow_changed_law();
}

void ClosingControl::follow_changed_law() {
  const ClosingSchedule schedule(closing_, schedules_.front().open_length());
  transition_.emplace(schedule, changed_, at_change_);
}

double ClosingControl::shortest_length(std::int32_t rope, double now, double until) const {
  const auto index = static_cast<std::size_t>(rope);
  if (index >= schedule_of_rope_.size()) return std::numeric_limits<double>::infinity();
  return std::min(motion(index, now).length, motion(index, until).length);
}

std::string ClosingControl::suspicion() const {
  if (fastest_ <= kFastWinding) return {};
  return fmt::format(
      "the likely cause is the closing, which winds ropes at up to {:.3g} m/s: close more slowly (closing.duration is "
      "{:g} s)",
      fastest_, closing_.duration);
}

void ClosingControl::visit_state(const std::function<void(double&)>& visit) {
  for (double* value : {&changed_, &at_change_.length, &at_change_.speed, &at_change_.acceleration, &fastest_}) {
    visit(*value);
  }
  if (times_) closing_.start = times_->closing_start;
  make_schedules();
  if (changed_ >= 0) {
    follow_changed_law();
  } else {
    transition_.reset();
  }
}

}  // namespace netpocket
