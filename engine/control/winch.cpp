#include "engine/control/winch.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace netpocket {
namespace {

const WinchSettings& checked_winch(const WinchSettings& settings, double length) {
  const auto is_positive = [](double value) { return value > 0 && std::isfinite(value); };
  if (!is_positive(settings.drum_radius) || !is_positive(settings.drum_inertia))
    throw std::invalid_argument("a winch needs a positive drum radius and drum inertia");
  if (!(settings.most_torque >= 0 && settings.brake_torque >= 0 && settings.fastest >= 0))
    throw std::invalid_argument("the limits of a winch must not be negative");
  if (!(settings.slip_tension >= 0) || !(length <= settings.most_length))
    throw std::invalid_argument("a winch needs a clutch that holds, and no more rope outside than it has");
  if (!is_positive(settings.least_length) || !(length >= settings.least_length))
    throw std::invalid_argument("the rope of a winch must not be shorter than its least length");
  return settings;
}

PidSettings rate_loop_settings(const WinchSettings& settings) {
  const double most = settings.most_torque / settings.drum_radius;
  return {.proportional = settings.rate_gain, .integral = settings.rate_integral, .least = -most, .most = most};
}

}  // namespace

Winch::Winch(const WinchSettings& settings, double length)
    : settings_(checked_winch(settings, length)),
      mass_(settings.drum_inertia / (settings.drum_radius * settings.drum_radius)),
      motion_{length, 0, 0},
      rate_loop_(rate_loop_settings(settings)) {}

double Winch::wanted_rate(double tension, double tension_rate) const {
  double rate = command_.value;
  if (command_.mode == WinchMode::length) {
    rate = command_.rate - settings_.length_gain * (motion_.length - command_.value);
  } else if (command_.mode == WinchMode::tension) {
    rate = settings_.tension_gain * (tension - command_.value) + settings_.tension_derivative * tension_rate;
    if (tension <= settings_.slack_tension) rate = std::min(rate, -settings_.take_up_rate);
  }
  return std::clamp(rate, -settings_.fastest, settings_.fastest);
}

double Winch::motor_force(double tension, double dt) {
  const double tension_rate = started_ ? (tension - last_tension_) / dt : 0;
  if (command_.brake) rate_loop_.reset();
  if (command_.brake) return 0;
  if (command_.mode == WinchMode::torque) {
    return std::clamp(command_.value, -settings_.most_torque, settings_.most_torque) / settings_.drum_radius;
  }
  return -rate_loop_.update(motion_.rate - wanted_rate(tension, tension_rate), 0, dt);
}

// The rate that brake, jam and least length leave of a rate at the end of a step.
double Winch::stopped_rate(double rate, double dt) const {
  if (jammed_) return 0;
  if (command_.brake) {
    const double most = std::min(settings_.slip_tension, command_.most_brake);
    const double brake = std::min(settings_.brake_torque / settings_.drum_radius, most);
    const double grip = brake * dt / mass_;
    rate -= std::clamp(rate, -grip, grip);
  }
  rate = std::min(rate, (settings_.most_length - motion_.length) / dt);
  return std::max(rate, (settings_.least_length - motion_.length) / dt);
}

const RopeMotion& Winch::step(double tension, double measured, double dt) {
  force_ = jammed_ ? 0 : std::clamp(motor_force(measured, dt), -settings_.slip_tension, settings_.slip_tension);
  const double before = motion_.rate;
  const double driven = before + dt * (tension - force_) / mass_;
  const double after = stopped_rate(driven, dt);
  const double mean = 0.5 * (before + after);
  power_ = -force_ * mean;
  motor_work_ += power_ * dt;
  rope_work_ += tension * mean * dt;
  losses_ += mass_ * (driven - after) * mean;
  const double length = std::min(motion_.length + dt * after, settings_.most_length);
  motion_ = {std::max(length, settings_.least_length), after, (after - before) / dt};
  last_tension_ = measured;
  started_ = true;
  return motion_;
}

double Winch::kinetic_energy() const { return 0.5 * mass_ * motion_.rate * motion_.rate; }

void Winch::visit_state(const NumberVisitor& visit) {
  auto mode = static_cast<std::uint64_t>(command_.mode);
  visit_count(visit, mode);
  command_.mode = static_cast<WinchMode>(std::min<std::uint64_t>(mode, 3));
  for (bool* flag : {&command_.brake, &jammed_, &started_}) visit_flag(visit, *flag);
  for (double* number :
       {&command_.value, &command_.rate, &command_.most_brake, &motion_.length, &motion_.rate, &motion_.acceleration,
        &last_tension_, &force_, &power_, &motor_work_, &rope_work_, &losses_}) {
    visit(*number);
  }
  rate_loop_.visit_state(visit);
}

}  // namespace netpocket
