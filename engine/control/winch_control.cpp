#include "engine/control/winch_control.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/control/observed.h"

namespace netpocket {
namespace {

// The drive `length` may wind a little beyond the closed length before it corrects itself.
constexpr double kOvershoot = 0.1;  // part of the shortest length

double least_length_of(const Scenario& scenario, const std::vector<double>& open_lengths) {
  const double shortest = ClosingSchedule(scenario.closing, open_lengths.front()).shortest();
  return scenario.winch.drive == WinchDrive::length ? (1 - kOvershoot) * shortest : shortest;
}

// The number that a list has for a rope (from 1), or another one.
double listed(const std::vector<Eigen::Vector2d>& rows, std::size_t rope, double otherwise) {
  for (const Eigen::Vector2d& row : rows) {
    if (row.x() == static_cast<double>(rope + 1)) return row.y();
  }
  return otherwise;
}

WinchSettings settings_of(const WinchParameters& winch, double least_length) {
  return {.drum_radius = winch.drum_radius,
          .drum_inertia = winch.drum_inertia,
          .most_torque = winch.most_torque,
          .brake_torque = winch.brake_torque,
          .fastest = winch.fastest,
          .least_length = least_length,
          .rate_gain = winch.rate_gain,
          .rate_integral = winch.rate_integral,
          .length_gain = winch.length_gain,
          .tension_gain = winch.tension_gain,
          .tension_derivative = winch.tension_derivative,
          .take_up_rate = winch.take_up_rate};
}

}  // namespace

WinchControl::WinchControl(const Scenario& scenario, const std::vector<double>& open_lengths,
                           std::shared_ptr<const CaptureTimes> times)
    : winch_(scenario.winch),
      least_length_(least_length_of(scenario, open_lengths)),
      open_lengths_(open_lengths),
      times_(std::move(times)),
      law_(scenario.closing, open_lengths, times_),
      tensions_(open_lengths.size(), 0.0) {
  for (const double open : open_lengths) winches_.emplace_back(settings_of(winch_, least_length_), open);
  for (const SensorParameters& sensor : scenario.sensors) {
    if (sensor.kind == SensorKind::rope_tension) sensor_.emplace(sensor_channel(sensor, open_lengths.size()));
  }
}

// The command at a rope's own time (s), which is behind that of the others if the rope is late.
WinchCommand WinchControl::command_at_own(std::size_t rope, double own_time) const {
  if (own_time < times_->closing_start) return {.mode = WinchMode::rate, .brake = true};
  switch (winch_.drive) {
    case WinchDrive::rate:
      return {.mode = WinchMode::rate, .value = -winch_.rate};
    case WinchDrive::tension:
      return {.mode = WinchMode::tension, .value = winch_.tension};
    case WinchDrive::torque:
      return {.mode = WinchMode::torque, .value = winch_.torque};
    case WinchDrive::length:
    case WinchDrive::prescribed:
      break;
  }
  const RopeMotion wanted = law_.motion(rope, own_time);
  return {.mode = WinchMode::length, .value = wanted.length, .rate = wanted.rate};
}

// The command for a step that ends at `time` (s).
WinchCommand WinchControl::command_at(std::size_t rope, double time) const {
  return command_at_own(rope, time - listed(winch_.late, rope, 0));
}

// As command_at for each rope. Most ropes have the law and the time of the rope before.
void WinchControl::command_all(double time) {
  WinchCommand last;
  double last_time = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t rope = 0; rope < winches_.size(); ++rope) {
    const double own_time = time - listed(winch_.late, rope, 0);
    const bool is_new = own_time != last_time || law_.laws()[rope] != law_.laws()[rope - 1];
    if (is_new) last = command_at_own(rope, own_time);
    last_time = own_time;
    winches_[rope].command(last);
  }
}

LoopState WinchControl::state(std::size_t rope, double time) const {
  if (time >= listed(winch_.jammed, rope, std::numeric_limits<double>::infinity())) return LoopState::jammed;
  if (command_at(rope, time).brake) return LoopState::waiting;
  const bool is_done = winch_.drive != WinchDrive::length && winches_[rope].motion().length <= least_length_;
  return is_done ? LoopState::over : LoopState::active;
}

double WinchControl::load(std::size_t rope) const {
  const double torque = std::abs(winches_[rope].torque());
  return torque > 0 ? torque / winch_.most_torque : 0;
}

void WinchControl::update(const Measurements& measurements, double interval, Commands& commands) {
  const double now = measurements.time();
  longest_step_ = std::max(longest_step_, interval);
  law_.follow_start();
  measurements.rope_tensions(tensions_);
  if (sensor_) sensor_->look(now, tensions_);
  command_all(now + interval);
  for (std::size_t rope = 0; rope < winches_.size(); ++rope) {
    Winch& winch = winches_[rope];
    winch.jam(now >= listed(winch_.jammed, rope, std::numeric_limits<double>::infinity()));
    const double known = sensor_ ? sensor_->reading()[rope] : tensions_[rope];
    commands.wind(static_cast<std::int32_t>(rope), winch.step(tensions_[rope], known, interval));
  }
}

void WinchControl::change(const Scenario& scenario, double now) {
  law_.change(scenario, now);
  if (scenario.winch == winch_) return;
  winch_ = scenario.winch;
  for (std::size_t rope = 0; rope < winches_.size(); ++rope) {
    Winch next(settings_of(winch_, least_length_), open_lengths_[rope]);
    std::vector<double> state;
    winches_[rope].visit_state([&](double& number) { state.push_back(number); });
    std::size_t place = 0;
    next.visit_state([&](double& number) { number = state[place++]; });
    winches_[rope] = std::move(next);
  }
}

double WinchControl::shortest_length(std::int32_t rope, double now, double until) const {
  const auto index = static_cast<std::size_t>(rope);
  if (index >= winches_.size()) return std::numeric_limits<double>::infinity();
  const RopeMotion& motion = winches_[index].motion();
  const double fastest = std::max(winch_.fastest, std::abs(motion.rate));
  return std::max(std::min(least_length_, motion.length), motion.length - fastest * (until - now));
}

std::string WinchControl::suspicion() const {
  const double mass = winch_.drum_inertia / (winch_.drum_radius * winch_.drum_radius);
  const double most = 2 * mass / longest_step_;
  if (longest_step_ == 0 || winch_.rate_gain < most) return {};
  return fmt::format(
      "the likely cause is winch.rate_gain, which makes the motors' loop unstable for these drums above {:.3g} N s/m",
      most);
}

void WinchControl::visit_state(const std::function<void(double&)>& visit) {
  law_.visit_state(visit);
  for (Winch& winch : winches_) winch.visit_state(visit);
  visit_numbers(visit, tensions_);
  if (sensor_) sensor_->visit_state(visit);
  visit(longest_step_);
}

}  // namespace netpocket
