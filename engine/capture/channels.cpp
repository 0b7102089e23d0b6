#include "engine/capture/channels.h"

#include <algorithm>

#include "engine/math/elementary.h"
#include "engine/state/pocket_groups.h"

namespace netpocket {
namespace {

struct Mouth {
  double side = 0;       // m, mean distance between adjacent tips
  double side_rate = 0;  // m/s
  double radius = 0;     // m, mean distance of the tips from their centre
};

Mouth measure_mouth(const Snapshot& snapshot, const std::vector<std::int32_t>& tips) {
  Mouth mouth;
  const auto count = tips.size();
  if (count == 0) return mouth;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  for (const std::int32_t tip : tips) centre += snapshot.positions.col(tip) / static_cast<double>(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::int32_t a = tips[i], b = tips[(i + 1) % count];
    const Eigen::Vector3d span = snapshot.positions.col(b) - snapshot.positions.col(a);
    const double length = span.norm();
    mouth.side += length / static_cast<double>(count);
    mouth.side_rate +=
        span.dot(snapshot.velocities.col(b) - snapshot.velocities.col(a)) / length / static_cast<double>(count);
    mouth.radius += (snapshot.positions.col(a) - centre).norm() / static_cast<double>(count);
  }
  return mouth;
}

// Radius of a polyline of points (radius, height) at a height; negative outside its heights.
double radius_at(const std::vector<Eigen::Vector2d>& outline, double height) {
  for (std::size_t i = 0; i + 1 < outline.size(); ++i) {
    const double below = outline[i].y(), above = outline[i + 1].y();
    if (height < below || height > above || above == below) continue;
    const double part = (height - below) / (above - below);
    return (1 - part) * outline[i].x() + part * outline[i + 1].x();
  }
  return -1;
}

// Whether the target's centre lies between root and mouth, and nearer to the pocket's axis than the rods at its height.
// Heights and radii are in the spacecraft's axes. Rods are polylines through their mean root, kink and tip.
bool target_is_inside(const Snapshot& snapshot, const Structure& structure, std::int32_t spacecraft,
                      std::int32_t target) {
  const BodyState& craft = snapshot.bodies[spacecraft];
  const auto to_craft = [&](const Eigen::Vector3d& point) -> Eigen::Vector3d {
    return craft.attitude.conjugate() * (point - craft.position);
  };
  const auto mean = [&](const std::vector<std::int32_t>& nodes) -> Eigen::Vector2d {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (const std::int32_t node : nodes) {
      const Eigen::Vector3d p = to_craft(snapshot.positions.col(node));
      sum += Eigen::Vector2d(hypotenuse(p.x(), p.z()), p.y());
    }
    return sum / static_cast<double>(nodes.size());
  };
  if (structure.nodes(kRodTips).empty()) return false;
  const Eigen::Vector3d centre = to_craft(snapshot.bodies[target].position);
  const double radius =
      radius_at({mean(structure.nodes(kRodRoots)), mean(structure.nodes(kRodKinks)), mean(structure.nodes(kRodTips))},
                centre.y());
  return hypotenuse(centre.x(), centre.z()) < radius;
}

void fill_depths(Snapshot& snapshot, const ContactDepths& depths) {
  snapshot.channel(Channel::penetration_max) = depths.penetration;
  snapshot.channel(Channel::penetration_part) = depths.pressed.part;
  snapshot.channel(Channel::penetration_element) = depths.pressed.element;
  snapshot.channel(Channel::penetration_body) = depths.pressed.partner;
  snapshot.channel(Channel::penetration_stiffness) = depths.pressed.stiffness;
  snapshot.channel(Channel::overlap_part) = depths.overlapping.part;
  snapshot.channel(Channel::overlap_element) = depths.overlapping.element;
  snapshot.channel(Channel::overlap_other) = depths.overlapping.partner;
  snapshot.channel(Channel::overlap_stiffness) = depths.overlapping.stiffness;
}

void fill_safeguards(Snapshot& snapshot, const SafeguardCounts& counts) {
  snapshot.channel(Channel::shortened_steps) = static_cast<double>(counts.shortened_steps);
  snapshot.channel(Channel::limited_hinges) = static_cast<double>(counts.limited_hinges);
  snapshot.channel(Channel::loose_hinges) = static_cast<double>(counts.loose_hinges);
  snapshot.channel(Channel::stopped_blows) = static_cast<double>(counts.stopped_blows);
  snapshot.channel(Channel::unresolved_contacts) = static_cast<double>(counts.unresolved_contacts);
  snapshot.channel(Channel::stopped_cords) = static_cast<double>(counts.stopped_cords);
  snapshot.channel(Channel::parted_overlaps) = static_cast<double>(counts.parted_overlaps);
}

}  // namespace

void ChannelRecorder::fill(Snapshot& snapshot, const Structure& structure, CableSystem& system,
                           const EnergyAudit& energy, double time_step) {
  const auto set = [&](Channel c, double value) { snapshot.channel(c) = value; };
  const auto set3 = [&](Channel x, Channel y, Channel z, const Eigen::Vector3d& value) {
    set(x, value.x());
    set(y, value.y());
    set(z, value.z());
  };
  set(Channel::time, snapshot.time);
  const Mouth mouth = measure_mouth(snapshot, structure.nodes(kRodTips));
  set(Channel::closing_length, mouth.side);
  set(Channel::closing_speed, mouth.side_rate);
  set(Channel::mouth_radius, mouth.radius);
  if (!system.model().ropes.empty()) {
    set(Channel::commanded_length, system.rope_motion(0).length);
    set(Channel::commanded_speed, system.rope_motion(0).rate);
  }

  const Eigen::Vector3d impulse = system.contact_impulse(target_);
  const double interval = snapshot.time - last_time_;
  if (interval > 0) {
    set3(Channel::contact_fx, Channel::contact_fy, Channel::contact_fz, (impulse - last_impulse_) / interval);
  }
  last_time_ = snapshot.time;
  last_impulse_ = impulse;
  const auto touches_target = [&](const ContactPoint& contact) {
    return contact.body == target_ && contact.element >= 0;
  };
  set(Channel::contact_count, static_cast<double>(std::ranges::count_if(snapshot.contacts, touches_target)));

  const BodyState& target = snapshot.bodies[target_];
  const BodyState& craft = snapshot.bodies[spacecraft_];
  set3(Channel::target_x, Channel::target_y, Channel::target_z, target.position);
  set3(Channel::target_vx, Channel::target_vy, Channel::target_vz, target.velocity);
  set3(Channel::spacecraft_x, Channel::spacecraft_y, Channel::spacecraft_z, craft.position);
  set3(Channel::spacecraft_vx, Channel::spacecraft_vy, Channel::spacecraft_vz, craft.velocity);
  set(Channel::target_inside, target_is_inside(snapshot, structure, spacecraft_, target_) ? 1 : 0);

  double net_tension = 0, rope_tension = 0;
  std::size_t rope_elements = 0;
  for (std::size_t i = 0; i < structure.elements.size(); ++i) {
    const double tension = snapshot.tension[static_cast<Eigen::Index>(i)];
    const std::int32_t group = structure.elements[i].group;
    if (group == index_of(PocketGroup::net)) net_tension = std::max(net_tension, tension);
    if (group == index_of(PocketGroup::closing_ropes)) {
      rope_tension += tension;
      ++rope_elements;
    }
  }
  set(Channel::rope_tension_max, net_tension);
  set(Channel::closing_tension, rope_elements > 0 ? rope_tension / static_cast<double>(rope_elements) : 0);
  fill_depths(snapshot, system.take_deepest_contacts());

  set(Channel::energy_kinetic, energy.kinetic);
  set(Channel::energy_strain, energy.strain);
  set(Channel::energy_contact, energy.contact);
  set(Channel::energy_input, energy.input);
  set(Channel::energy_dissipated, energy.spent.total());
  set(Channel::spent_in_cords, energy.spent.in_cords);
  set(Channel::spent_at_hinges, energy.spent.at_hinges);
  set(Channel::spent_in_contacts, energy.spent.in_contacts);
  set(Channel::spent_by_friction, energy.spent.by_friction);
  set(Channel::energy_error, energy.error);
  set(Channel::time_step, time_step);
  set(Channel::contact_step, system.contact_step());
  fill_safeguards(snapshot, system.safeguards());
}

void ChannelRecorder::visit_state(const std::function<void(double&)>& visit) {
  visit(last_time_);
  for (double& component : last_impulse_) visit(component);
}

}  // namespace netpocket
