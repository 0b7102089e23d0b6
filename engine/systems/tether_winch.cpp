#include "engine/systems/tether_winch.h"

#include <limits>
#include <utility>

namespace netpocket {
namespace {

// The motor's loop turns an error of the rate into force as if it gave the drum that error within this time (s).
constexpr double kRateTime = 0.02;

WinchSettings settings_of(const TetherDrum& drum) {
  const double drum_mass = drum.inertia / (drum.radius * drum.radius);
  return {.drum_radius = drum.radius,
          .drum_inertia = drum.inertia,
          .most_torque = drum.motor_torque,
          .brake_torque = drum.slip_tension * drum.radius,
          .fastest = drum.fastest,
          .least_length = drum.least_length,
          .rate_gain = drum_mass / kRateTime,
          .tension_gain = 0.02,
          .slip_tension = drum.slip_tension,
          .most_length = drum.length + drum.reserve};
}

}  // namespace

void add_wound_tether(Model& model, const TetherDrum& drum, const CableSection& section, std::int32_t eye,
                      std::int32_t far_end) {
  for (const std::int32_t end : {eye, far_end}) {
    model.nodes[static_cast<std::size_t>(end)].point_mass +=
        0.5 * section.mass_per_length * (drum.length + drum.reserve);
  }
  model.ring_ropes.push_back({.nodes = {eye, far_end},
                              .lengths = {drum.length},
                              .stiffness = section.EA,
                              .damping = section.axial_damping,
                              .least_part = drum.least_length,
                              .share_at_start = 1});
  model.node_groups.push_back({"wound tether", NodeLook::rope, {eye, far_end}});
}

TetherWinch::TetherWinch(const Scenario& scenario, const Parts& parts, std::shared_ptr<const CaptureTimes> times)
    : drum_(tether_drum(scenario)),
      parts_(parts),
      times_(std::move(times)),
      first_touch_(std::numeric_limits<double>::infinity()),
      winch_(settings_of(drum_), drum_.length) {}

double TetherWinch::time_of(DrumEvent event) const {
  switch (event) {
    case DrumEvent::contact:
      return first_touch_;
    case DrumEvent::closed:
      return times_->closing_end;
    case DrumEvent::time:
      break;
  }
  return 0;
}

WinchCommand TetherWinch::command_at(double time, bool is_held) const {
  const double brake_delay = drum_.brake_event == DrumEvent::time ? drum_.brake_at : drum_.brake_delay;
  const bool is_driven = time >= time_of(drum_.drive_event) + drum_.drive_delay;
  if (is_held || !is_driven || time >= time_of(drum_.brake_event) + brake_delay) {
    return {.mode = WinchMode::rate, .brake = true};
  }
  switch (drum_.drive) {
    case TetherDrive::rate:
      return {.mode = WinchMode::rate, .value = drum_.rate};
    case TetherDrive::tension:
      return {.mode = WinchMode::tension, .value = drum_.tension};
    case TetherDrive::drag:
      return {.mode = WinchMode::rate, .brake = true, .most_brake = drum_.tension};
    case TetherDrive::brake:
      break;
  }
  return {.mode = WinchMode::rate, .brake = true};
}

void TetherWinch::update(const Measurements& measurements, double interval, Commands& commands) {
  const double now = measurements.time();
  const bool touches = !measurements.contact_impulse(parts_.target).isZero(0);
  if (touches) first_touch_ = std::min(first_touch_, now);
  const bool is_held = parts_.held >= 0 && measurements.is_held(parts_.held);
  winch_.command(command_at(now + interval, is_held));
  commands.wind(parts_.rope, winch_.step(measurements.rope_tension(parts_.rope), interval));
}

void TetherWinch::change(const Scenario& scenario, double /*now*/) {
  const double length = drum_.length;  // at the start of the run
  drum_ = tether_drum(scenario);
  Winch next(settings_of(drum_), length);
  std::vector<double> state;
  winch_.visit_state([&](double& number) { state.push_back(number); });
  std::size_t place = 0;
  next.visit_state([&](double& number) { number = state[place++]; });
  winch_ = std::move(next);
}

void TetherWinch::visit_state(const std::function<void(double&)>& visit) {
  visit(first_touch_);
  winch_.visit_state(visit);
}

std::vector<ChannelInfo> wound_tether_channels() {
  return {{"tether_length", "m", "length of the tether outside its drum"},
          {"tether_rate", "m/s", "rate at which the drum pays out"}};
}

}  // namespace netpocket
