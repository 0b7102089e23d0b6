#pragma once
// The scalar channels of a run: one value per recorded frame. Declared once; the recording, channels.csv, the plots and
// the documentation all use this table.

#include <array>
#include <cstddef>
#include <string_view>

namespace netpocket {

enum class Channel : std::size_t {
  time,
  closing_length,
  closing_speed,
  commanded_length,
  commanded_speed,
  contact_fx,
  contact_fy,
  contact_fz,
  contact_count,
  target_x,
  target_y,
  target_z,
  target_vx,
  target_vy,
  target_vz,
  target_inside,
  spacecraft_x,
  spacecraft_y,
  spacecraft_z,
  spacecraft_vx,
  spacecraft_vy,
  spacecraft_vz,
  mouth_radius,
  rope_tension_max,
  closing_tension,
  penetration_max,
  energy_kinetic,
  energy_strain,
  energy_input,
  energy_dissipated,
  energy_error,
  time_step,
  count
};

inline constexpr std::size_t kChannelCount = static_cast<std::size_t>(Channel::count);

struct ChannelInfo {
  std::string_view name;
  std::string_view unit;
  std::string_view help;
};

inline constexpr std::array<ChannelInfo, kChannelCount> kChannels = {{
    {"time", "s", "simulated time"},
    {"closing_length", "m", "distance between adjacent rod tips, mean over the sides"},
    {"closing_speed", "m/s", "rate of closing_length"},
    {"commanded_length", "m", "rope length between adjacent tips that the closing law asks for"},
    {"commanded_speed", "m/s", "rate of commanded_length"},
    {"contact_fx", "N",
     "x component of the force of cords, ropes and rods on the target, mean over the output interval"},
    {"contact_fy", "N",
     "y component of the force of cords, ropes and rods on the target, mean over the output interval"},
    {"contact_fz", "N",
     "z component of the force of cords, ropes and rods on the target, mean over the output interval"},
    {"contact_count", "1", "contact points of cords, ropes and rods with the target"},
    {"target_x", "m", "target's centre of mass"},
    {"target_y", "m", "target's centre of mass"},
    {"target_z", "m", "target's centre of mass"},
    {"target_vx", "m/s", "velocity of the target's centre of mass"},
    {"target_vy", "m/s", "velocity of the target's centre of mass"},
    {"target_vz", "m/s", "velocity of the target's centre of mass"},
    {"target_inside", "1", "1 while the target's centre of mass is inside the pocket, else 0"},
    {"spacecraft_x", "m", "spacecraft's centre of mass"},
    {"spacecraft_y", "m", "spacecraft's centre of mass"},
    {"spacecraft_z", "m", "spacecraft's centre of mass"},
    {"spacecraft_vx", "m/s", "velocity of the spacecraft's centre of mass"},
    {"spacecraft_vy", "m/s", "velocity of the spacecraft's centre of mass"},
    {"spacecraft_vz", "m/s", "velocity of the spacecraft's centre of mass"},
    {"mouth_radius", "m", "distance of the rod tips from their centre, mean over the rods"},
    {"rope_tension_max", "N", "largest tension in a net cord"},
    {"closing_tension", "N", "tension in the closing ropes, mean over the sides"},
    {"penetration_max", "m", "deepest penetration of a cord into a body since the last frame"},
    {"energy_kinetic", "J", "kinetic energy of everything"},
    {"energy_strain", "J", "strain energy of cords, rods and hinges"},
    {"energy_input", "J", "work put in so far by retractors, thrust and gravity"},
    {"energy_dissipated", "J", "energy turned into heat so far by damping, contact and friction"},
    {"energy_error", "J", "kinetic + strain + dissipated - input - their sum at the start"},
    {"time_step", "s", "integration step in use"},
}};

}  // namespace netpocket
