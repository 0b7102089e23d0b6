#include "engine/systems/pocket/tether_winch.h"

#include <utility>

namespace netpocket {
namespace {

// The motor's loop turns an error of the rate into force as if it gave the drum that error within this time (s).
constexpr double kRateTime = 0.02;

WinchSettings settings_of(const PocketTether& tether) {
  const double drum_mass = tether.drum_inertia / (tether.drum_radius * tether.drum_radius);
  return {.drum_radius = tether.drum_radius,
          .drum_inertia = tether.drum_inertia,
          .most_torque = tether.motor_torque,
          .brake_torque = tether.slip_tension * tether.drum_radius,
          .fastest = tether.fastest,
          .least_length = tether.least_length,
          .rate_gain = drum_mass / kRateTime,
          .tension_gain = 0.02,
          .slip_tension = tether.slip_tension,
          .most_length = tether.length + tether.reserve};
}

}  // namespace

TetherWinch::TetherWinch(const Scenario& scenario, std::int32_t rope, std::int32_t hub)
    : tether_(pocket_tether(scenario)), rope_(rope), hub_(hub), winch_(settings_of(tether_), tether_.length) {}

WinchCommand TetherWinch::command_at(double time, bool is_held) const {
  if (is_held || time >= tether_.brake_at) return {.mode = WinchMode::rate, .brake = true};
  switch (tether_.drive) {
    case TetherDrive::rate:
      return {.mode = WinchMode::rate, .value = tether_.rate};
    case TetherDrive::tension:
      return {.mode = WinchMode::tension, .value = tether_.tension};
    case TetherDrive::brake:
      break;
  }
  return {.mode = WinchMode::rate, .brake = true};
}

void TetherWinch::update(const Measurements& measurements, double interval, Commands& commands) {
  winch_.command(command_at(measurements.time() + interval, measurements.is_held(hub_)));
  commands.wind(rope_, winch_.step(measurements.rope_tension(rope_), interval));
}

void TetherWinch::change(const Scenario& scenario, double /*now*/) {
  tether_ = pocket_tether(scenario);
  Winch next(settings_of(tether_), tether_.length);
  std::vector<double> state;
  winch_.visit_state([&](double& number) { state.push_back(number); });
  std::size_t place = 0;
  next.visit_state([&](double& number) { number = state[place++]; });
  winch_ = std::move(next);
}

}  // namespace netpocket
