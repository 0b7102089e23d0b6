#pragma once
// The scalar channels of a run. Each has one value per recorded frame. The list of a run's channels is data: its
// structure and its snapshots carry the list, and its recording stores it. Code that reads, draws or exports channels
// must use that list.
//
// The enumeration `Channel` names the channels that parts of this program look up. A run need not have them, and may
// have others.

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

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

inline constexpr std::size_t kKnownChannelCount = static_cast<std::size_t>(Channel::count);

enum class ChannelKind : std::uint8_t {
  value,     // at the time of the frame
  interval,  // mean or extreme since the previous frame
  total,     // since the start of the run
  index      // row of a table of the structure; -1: none
};

struct ChannelInfo {
  std::string name;  // letters, digits, underscores
  std::string unit;  // "1" for pure numbers
  std::string meaning;
  ChannelKind kind = ChannelKind::value;

  bool operator==(const ChannelInfo&) const = default;
};

// Ordered list of distinct channels. Immutable; the structure and the snapshots of a run share it.
class ChannelList {
 public:
  // Throws std::invalid_argument, with one sentence, if two channels have the same name or none is called "time".
  explicit ChannelList(std::vector<ChannelInfo> channels);

  std::size_t size() const { return channels_.size(); }
  const ChannelInfo& operator[](std::size_t index) const { return channels_[index]; }
  auto begin() const { return channels_.begin(); }
  auto end() const { return channels_.end(); }

  // Index of a channel; empty if the list does not contain it.
  std::optional<std::size_t> find(std::string_view name) const;
  std::optional<std::size_t> find(Channel channel) const { return known_[static_cast<std::size_t>(channel)]; }
  bool has(Channel channel) const { return find(channel).has_value(); }

 private:
  std::vector<ChannelInfo> channels_;
  std::array<std::optional<std::size_t>, kKnownChannelCount> known_{};
};

// All channels of the enumeration `Channel`, in its order: the channels of a pocket.
const std::shared_ptr<const ChannelList>& known_channels();
const ChannelInfo& channel_info(Channel channel);
// Those of them that any capture system has, whatever its kind. Channels of the spacecraft and of the target: if it has
// these bodies.
std::vector<ChannelInfo> common_channels(bool spacecraft, bool target);

const char* to_string(ChannelKind kind);
std::optional<ChannelKind> channel_kind(std::string_view text);

}  // namespace netpocket
