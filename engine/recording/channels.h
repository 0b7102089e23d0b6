#pragma once
// The scalar channels of a run: one value per recorded frame. Declared once; the recording, channels.csv, the plots and
// the documentation all use this table.
//
// A channel that is added later is not `required`: recordings made before it existed are read without it. Its values
// are then NaN.

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
  penetration_part,
  penetration_element,
  penetration_body,
  penetration_stiffness,
  overlap_part,
  overlap_element,
  overlap_other,
  overlap_stiffness,
  energy_kinetic,
  energy_strain,
  energy_contact,
  energy_input,
  energy_dissipated,
  spent_in_cords,
  spent_at_hinges,
  spent_in_contacts,
  spent_by_friction,
  energy_error,
  time_step,
  contact_step,
  shortened_steps,
  limited_hinges,
  loose_hinges,
  stopped_blows,
  unresolved_contacts,
  stopped_cords,
  parted_overlaps,
  count
};

inline constexpr std::size_t kChannelCount = static_cast<std::size_t>(Channel::count);

struct ChannelInfo {
  std::string_view name;
  std::string_view unit;
  std::string_view help;
  bool required = true;
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
    {"penetration_part", "1", "the same by the cord's radius, the largest since the last frame", false},
    {"penetration_element", "1", "where that is: row of structure/element_*; -1: nowhere", false},
    {"penetration_body", "1", "and row of structure/body_*", false},
    {"penetration_stiffness", "1", "stiffness of that contact by that of the materials", false},
    {"overlap_part", "1", "deepest overlap of two cords by the sum of their radii, since the last frame", false},
    {"overlap_element", "1", "where that is: row of structure/element_*; -1: nowhere", false},
    {"overlap_other", "1", "and that of the other cord", false},
    {"overlap_stiffness", "1", "stiffness of that contact by that of the materials", false},
    {"energy_kinetic", "J", "kinetic energy of everything"},
    {"energy_strain", "J", "strain energy of cords, rods and hinges"},
    {"energy_contact", "J", "energy in the springs of contacts", false},
    {"energy_input", "J", "work put in so far by retractors, thrust and gravity"},
    {"energy_dissipated", "J", "energy turned into heat so far: the sum of the four channels spent_"},
    {"spent_in_cords", "J", "of that by damping in cords, ropes and rods", false},
    {"spent_at_hinges", "J", "of that by the dampers of hinges", false},
    {"spent_in_contacts", "J", "of that by the dampers of contacts and by blows that they stop", false},
    {"spent_by_friction", "J", "of that by friction in contacts", false},
    {"energy_error", "J", "kinetic + strain + contact + dissipated - input - their sum at the start"},
    {"time_step", "s", "integration step in use"},
    {"contact_step", "s", "step that contacts are no stiffer than resolved by: the run's first; 0 before it", false},
    {"shortened_steps", "1", "steps so far that were shorter than stability asks for", false},
    {"limited_hinges", "1", "times so far that a hinge's damper was limited in a step", false},
    {"loose_hinges", "1", "times so far that a hinge let go of a folded cord in a step", false},
    {"stopped_blows", "1", "times so far that a cord was stopped at its greatest depth in a body", false},
    {"unresolved_contacts", "1", "times so far that a contact's spring was too stiff for the step", false},
    {"stopped_cords", "1", "times so far that a cord was kept from passing through another", false},
    {"parted_overlaps", "1", "times so far that cords were found deeper in each other than springs are", false},
}};

constexpr const ChannelInfo& channel_info(Channel c) { return kChannels[static_cast<std::size_t>(c)]; }

}  // namespace netpocket
