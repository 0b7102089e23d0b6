#include "synthetic_run.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace netpocket {
namespace {

constexpr double kInterval = 0.01;  // s
constexpr double kDuration = 20;    // s
constexpr double kTowingStart = 10;
constexpr double kTargetMass = 200;
constexpr double kSpacecraftMass = 1210;
constexpr double kPi = 3.14159265358979323846;

double bump(double t, double centre, double half_width) {
  const double u = (t - centre) / half_width;
  return std::abs(u) < 1 ? 0.5 * (1 + std::cos(kPi * u)) : 0;
}

// Cycloidal closing law: value and rate of the length.
std::pair<double, double> closing_law(double t, double closing_time) {
  const double u = std::min(t / closing_time, 1.0);
  const double length = 5.78 - 3.68 * (u - std::sin(2 * kPi * u) / (2 * kPi));
  return {length, u < 1 ? -3.68 / closing_time * (1 - std::cos(2 * kPi * u)) : 0};
}

double ramp(double t, double begin, double length) { return std::clamp((t - begin) / length, 0.0, 1.0); }

}  // namespace

RunSeries synthetic_run(const std::string& name, double closing_time) {
  RunSeries run;
  run.name = name;
  run.phases = pocket_phases(0, closing_time, kTowingStart);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> spike(0, 1);
  double target_y = 7.5;
  double target_v = 0;
  double spacecraft_y = -1;
  double spacecraft_v = 0;
  double dissipated = 0;
  double input = 0;
  const double speed = 10 / closing_time;
  for (int i = 0; i * kInterval <= kDuration + 1e-9; ++i) {
    const double t = i * kInterval;
    const auto [length, rate] = closing_law(t, closing_time);
    const double envelope =
        -25 * speed * bump(t, 0.62 * closing_time, 0.5) + 21 * speed * bump(t, 0.8 * closing_time, 0.6) -
        9 * speed * bump(t, 0.94 * closing_time, 0.4) - 2 * ramp(t, kTowingStart, 1) * ramp(14, t, 0.5);
    const double force = envelope * (0.55 + 0.9 * std::pow(spike(random), 3));
    const double lateral = ramp(t, closing_time, 0.5) * (spike(random) > 0.8 ? 3.0 : 0.6);
    const double acceleration = 0.01 * ramp(t, kTowingStart, 0.5) * ramp(14.5, t, 0.5);
    target_v += (force / kTargetMass - acceleration) * kInterval * 0.3;
    spacecraft_v += (-force / kSpacecraftMass * 0.3 - acceleration) * kInterval;
    if (t > 10.5) target_v += 0.01 * (spacecraft_v - target_v);
    target_y += target_v * kInterval;
    spacecraft_y += spacecraft_v * kInterval;
    input += std::abs(rate) * 4 * kInterval * 8 / 4;
    dissipated += 0.02 * std::abs(force) * kInterval;

    const auto set = [&](Channel channel, double value) { run.channel(channel).push_back(value); };
    set(Channel::time, t);
    set(Channel::commanded_length, length);
    set(Channel::commanded_speed, rate);
    set(Channel::closing_length, length + 0.006 * std::sin(9 * t) * bump(t, closing_time / 2, closing_time / 2));
    set(Channel::closing_speed, rate + 0.03 * std::sin(23 * t) * bump(t, closing_time / 2, closing_time / 2));
    set(Channel::contact_fx, lateral * std::sin(7 * t));
    set(Channel::contact_fy, force);
    set(Channel::contact_fz, lateral * std::cos(5 * t));
    set(Channel::target_x, 1.3e-3 * ramp(t, closing_time, 4) * std::sin(0.9 * (t - closing_time)));
    set(Channel::target_y, target_y);
    set(Channel::target_z, 0.8e-3 * ramp(t, closing_time, 5) * std::sin(0.7 * (t - closing_time)));
    set(Channel::spacecraft_x, -2.1e-5 * ramp(t, closing_time, 4) * std::sin(0.8 * (t - closing_time)));
    set(Channel::spacecraft_y, spacecraft_y);
    set(Channel::spacecraft_z, 1.4e-5 * ramp(t, closing_time, 5) * std::sin(0.6 * (t - closing_time)));
    set(Channel::rope_tension_max, 2 + 60 * speed * bump(t, 0.8 * closing_time, 2) * (0.7 + 0.6 * spike(random)));
    set(Channel::closing_tension, 4 * ramp(t, 0, 0.5) + 12 * bump(t, 0.9 * closing_time, 2.5) + 0.4 * std::sin(15 * t));
    set(Channel::energy_kinetic, 6 * bump(t, closing_time / 2, closing_time / 2) + 0.4 * ramp(t, 10, 4));
    set(Channel::energy_strain, 0.6 * input);
    set(Channel::energy_input, input);
    set(Channel::energy_contact, 2e-3 * std::abs(force));
    set(Channel::energy_dissipated, dissipated);
    set(Channel::spent_in_cords, 0.45 * dissipated);
    set(Channel::spent_at_hinges, 0.2 * dissipated);
    set(Channel::spent_in_contacts, 0.25 * dissipated);
    set(Channel::spent_by_friction, 0.1 * dissipated);
    set(Channel::energy_error, 2e-4 * input * std::sin(t));
  }
  return run;
}

}  // namespace netpocket
