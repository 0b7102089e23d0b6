#include "engine/capture/channels.h"

#include <algorithm>
#include <concepts>
#include <string_view>

namespace netpocket {
namespace {

// Writes channels that the snapshot has, and ignores all others.
class Writer {
 public:
  explicit Writer(Snapshot& snapshot) : snapshot_(snapshot) {}

  void set(Channel channel, double value) {
    if (snapshot_.channel_list->has(channel)) snapshot_.channel(channel) = value;
  }
  // Of systems in orbit (systems/orbital_frame.h).
  void set(std::string_view name, double value) {
    if (const auto index = snapshot_.channel_list->find(name)) snapshot_.channels[*index] = value;
  }
  void set(Channel channel, std::integral auto count) { set(channel, static_cast<double>(count)); }
  void set(Channel x, Channel y, Channel z, const Eigen::Vector3d& value) {
    set(x, value.x());
    set(y, value.y());
    set(z, value.z());
  }

 private:
  Snapshot& snapshot_;
};

void fill_depths(Writer& channels, const ContactDepths& depths) {
  channels.set(Channel::penetration_max, depths.penetration);
  channels.set(Channel::penetration_part, depths.pressed.part);
  channels.set(Channel::penetration_element, depths.pressed.element);
  channels.set(Channel::penetration_body, depths.pressed.partner);
  channels.set(Channel::penetration_stiffness, depths.pressed.stiffness);
  channels.set(Channel::overlap_part, depths.overlapping.part);
  channels.set(Channel::overlap_element, depths.overlapping.element);
  channels.set(Channel::overlap_other, depths.overlapping.partner);
  channels.set(Channel::overlap_stiffness, depths.overlapping.stiffness);
}

void fill_energies(Writer& channels, const EnergyAudit& energy) {
  channels.set(Channel::energy_kinetic, energy.kinetic);
  channels.set(Channel::energy_strain, energy.strain);
  channels.set(Channel::energy_contact, energy.contact);
  channels.set(Channel::energy_input, energy.input);
  channels.set(Channel::energy_dissipated, energy.spent.total());
  channels.set(Channel::spent_in_cords, energy.spent.in_cords);
  channels.set(Channel::spent_at_hinges, energy.spent.at_hinges);
  channels.set(Channel::spent_in_contacts, energy.spent.in_contacts);
  channels.set(Channel::spent_by_friction, energy.spent.by_friction);
  channels.set(Channel::energy_error, energy.error);
  channels.set("energy_tidal", energy.tidal);
}

void fill_safeguards(Writer& channels, const SafeguardCounts& counts) {
  channels.set(Channel::shortened_steps, counts.shortened_steps);
  channels.set(Channel::limited_hinges, counts.limited_hinges);
  channels.set(Channel::loose_hinges, counts.loose_hinges);
  channels.set(Channel::stopped_blows, counts.stopped_blows);
  channels.set(Channel::unresolved_contacts, counts.unresolved_contacts);
  channels.set(Channel::stopped_cords, counts.stopped_cords);
  channels.set(Channel::parted_overlaps, counts.parted_overlaps);
}

}  // namespace

void ChannelRecorder::fill_contact(Snapshot& snapshot, const CableSystem& system) {
  Writer channels(snapshot);
  const Eigen::Vector3d impulse = system.contact_impulse(target_);
  const double interval = snapshot.time - last_time_;
  if (interval > 0) {
    channels.set(Channel::contact_fx, Channel::contact_fy, Channel::contact_fz, (impulse - last_impulse_) / interval);
  }
  last_time_ = snapshot.time;
  last_impulse_ = impulse;
  const auto touches_target = [&](const ContactPoint& contact) {
    return contact.body == target_ && contact.element >= 0;
  };
  channels.set(Channel::contact_count, std::ranges::count_if(snapshot.contacts, touches_target));
}

void ChannelRecorder::fill(Snapshot& snapshot, CableSystem& system, const EnergyAudit& energy, double time_step) {
  Writer channels(snapshot);
  channels.set(Channel::time, snapshot.time);
  if (target_ >= 0) {
    fill_contact(snapshot, system);
    const BodyState& target = snapshot.bodies[static_cast<std::size_t>(target_)];
    channels.set(Channel::target_x, Channel::target_y, Channel::target_z, target.position);
    channels.set(Channel::target_vx, Channel::target_vy, Channel::target_vz, target.velocity);
  }
  if (spacecraft_ >= 0) {
    const BodyState& craft = snapshot.bodies[static_cast<std::size_t>(spacecraft_)];
    channels.set(Channel::spacecraft_x, Channel::spacecraft_y, Channel::spacecraft_z, craft.position);
    channels.set(Channel::spacecraft_vx, Channel::spacecraft_vy, Channel::spacecraft_vz, craft.velocity);
  }
  fill_depths(channels, system.take_deepest_contacts());
  fill_energies(channels, energy);
  fill_safeguards(channels, system.safeguards());
  channels.set(Channel::time_step, time_step);
  channels.set(Channel::contact_step, system.contact_step());
}

void ChannelRecorder::visit_state(const std::function<void(double&)>& visit) {
  visit(last_time_);
  for (double& component : last_impulse_) visit(component);
}

}  // namespace netpocket
