#include "engine/state/channels.h"

#include <algorithm>
#include <array>
#include <stdexcept>

namespace netpocket {
namespace {

constexpr std::array<const char*, 4> kKinds = {"value", "interval", "total", "index"};

std::vector<ChannelInfo> known() {
  using enum ChannelKind;
  return {
      {"time", "s", "simulated time", value},
      {"closing_length", "m", "distance between adjacent rod tips, mean over the sides", value},
      {"closing_speed", "m/s", "rate of closing_length", value},
      {"commanded_length", "m", "rope length between adjacent tips that the closing law asks for", value},
      {"commanded_speed", "m/s", "rate of commanded_length", value},
      {"contact_fx", "N",
       "x component of the force of cords, ropes and rods on the target, mean over the output interval", interval},
      {"contact_fy", "N",
       "y component of the force of cords, ropes and rods on the target, mean over the output interval", interval},
      {"contact_fz", "N",
       "z component of the force of cords, ropes and rods on the target, mean over the output interval", interval},
      {"contact_count", "1", "contact points of cords, ropes and rods with the target", value},
      {"target_x", "m", "target's centre of mass", value},
      {"target_y", "m", "target's centre of mass", value},
      {"target_z", "m", "target's centre of mass", value},
      {"target_vx", "m/s", "velocity of the target's centre of mass", value},
      {"target_vy", "m/s", "velocity of the target's centre of mass", value},
      {"target_vz", "m/s", "velocity of the target's centre of mass", value},
      {"target_inside", "1", "1 while the target's centre of mass is inside the pocket, else 0", value},
      {"spacecraft_x", "m", "spacecraft's centre of mass", value},
      {"spacecraft_y", "m", "spacecraft's centre of mass", value},
      {"spacecraft_z", "m", "spacecraft's centre of mass", value},
      {"spacecraft_vx", "m/s", "velocity of the spacecraft's centre of mass", value},
      {"spacecraft_vy", "m/s", "velocity of the spacecraft's centre of mass", value},
      {"spacecraft_vz", "m/s", "velocity of the spacecraft's centre of mass", value},
      {"mouth_radius", "m", "distance of the rod tips from their centre, mean over the rods", value},
      {"rope_tension_max", "N", "largest tension in a net cord", value},
      {"closing_tension", "N", "tension in the closing ropes, mean over the sides", value},
      {"penetration_max", "m", "deepest penetration of a cord into a body since the last frame", interval},
      {"penetration_part", "1", "the same by the cord's radius, the largest since the last frame", interval},
      {"penetration_element", "1", "where that is: row of structure/element_*; -1: nowhere", index},
      {"penetration_body", "1", "and row of structure/body_*", index},
      {"penetration_stiffness", "1", "stiffness of that contact by that of the materials", interval},
      {"overlap_part", "1", "deepest overlap of two cords by the sum of their radii, since the last frame", interval},
      {"overlap_element", "1", "where that is: row of structure/element_*; -1: nowhere", index},
      {"overlap_other", "1", "and that of the other cord", index},
      {"overlap_stiffness", "1", "stiffness of that contact by that of the materials", interval},
      {"energy_kinetic", "J", "kinetic energy of everything", value},
      {"energy_strain", "J", "strain energy of cords, rods and hinges", value},
      {"energy_contact", "J", "energy in the springs of contacts", value},
      {"energy_input", "J", "work put in so far by retractors, thrust and gravity", total},
      {"energy_dissipated", "J", "energy turned into heat so far: the sum of the four channels spent_", total},
      {"spent_in_cords", "J", "of that by damping in cords, ropes and rods", total},
      {"spent_at_hinges", "J", "of that by the dampers of hinges", total},
      {"spent_in_contacts", "J", "of that by the dampers of contacts and by blows that they stop", total},
      {"spent_by_friction", "J", "of that by friction in contacts", total},
      {"energy_error", "J", "kinetic + strain + contact + dissipated - input - their sum at the start", value},
      {"time_step", "s", "integration step in use", value},
      {"contact_step", "s", "step that contacts are no stiffer than resolved by: the run's first; 0 before it", value},
      {"shortened_steps", "1", "steps so far that were shorter than stability asks for", total},
      {"limited_hinges", "1", "times so far that a hinge's damper was limited in a step", total},
      {"loose_hinges", "1", "times so far that a hinge let go of a folded cord in a step", total},
      {"stopped_blows", "1", "times so far that a cord was stopped at its greatest depth in a body", total},
      {"unresolved_contacts", "1", "times so far that a contact's spring was too stiff for the step", total},
      {"stopped_cords", "1", "times so far that a cord was kept from passing through another", total},
      {"parted_overlaps", "1", "times so far that the spring between two cords began below the surface", total},
  };
}

}  // namespace

ChannelList::ChannelList(std::vector<ChannelInfo> channels) : channels_(std::move(channels)) {
  for (std::size_t i = 0; i < channels_.size(); ++i) {
    if (find(channels_[i].name) != i) throw std::invalid_argument("two channels are called " + channels_[i].name);
  }
  if (!find("time")) throw std::invalid_argument("there is no channel called time");
  static const std::vector<ChannelInfo> kKnown = known();
  for (std::size_t c = 0; c < kKnownChannelCount; ++c) known_[c] = find(kKnown[c].name);
}

std::optional<std::size_t> ChannelList::find(std::string_view name) const {
  for (std::size_t i = 0; i < channels_.size(); ++i) {
    if (channels_[i].name == name) return i;
  }
  return std::nullopt;
}

const std::shared_ptr<const ChannelList>& known_channels() {
  static const auto list = std::make_shared<const ChannelList>(known());
  return list;
}

const ChannelInfo& channel_info(Channel channel) { return (*known_channels())[static_cast<std::size_t>(channel)]; }

std::vector<ChannelInfo> common_channels(bool spacecraft, bool target) {
  constexpr std::array kOfPocket = {Channel::closing_length,   Channel::closing_speed,  Channel::commanded_length,
                                    Channel::commanded_speed,  Channel::target_inside,  Channel::mouth_radius,
                                    Channel::rope_tension_max, Channel::closing_tension};
  std::vector<ChannelInfo> channels;
  for (std::size_t c = 0; c < kKnownChannelCount; ++c) {
    const auto channel = static_cast<Channel>(c);
    const bool is_of_target = channel >= Channel::contact_fx && channel <= Channel::target_vz;
    const bool is_of_spacecraft = channel >= Channel::spacecraft_x && channel <= Channel::spacecraft_vz;
    if (std::ranges::count(kOfPocket, channel) > 0) continue;
    if ((is_of_target && !target) || (is_of_spacecraft && !spacecraft)) continue;
    channels.push_back(channel_info(channel));
  }
  return channels;
}

const char* to_string(ChannelKind kind) { return kKinds[static_cast<std::size_t>(kind)]; }

std::optional<ChannelKind> channel_kind(std::string_view text) {
  for (std::size_t i = 0; i < kKinds.size(); ++i) {
    if (text == kKinds[i]) return static_cast<ChannelKind>(i);
  }
  return std::nullopt;
}

}  // namespace netpocket
