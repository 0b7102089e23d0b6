#include "engine/dynamics/system/system_contacts.h"

#include <algorithm>

namespace netpocket {

SystemContacts::SystemContacts(const Model& model, const CableElements& elements, const CableState& state,
                               const SystemThreads& threads, int sectors)
    : elements_(elements),
      state_(state),
      threads_(threads),
      friction_(model.contact.friction),
      with_bodies_(model, state.layout),
      contacted_(state.layout.size()),
      impulses_(state.bodies.size(), Eigen::Vector3d::Zero()),
      body_impulses_(impulses_) {
  with_bodies_.set_sectors(sectors);
  if (model.contact.cords) {
    of_cords_ = std::make_unique<CordContact>(model, state.layout, state.coordinates, elements.inverse_mass());
  }
  if (model.contact.bodies && state.bodies.size() > 1) of_bodies_ = std::make_unique<BodyContact>(model, state.bodies);
}

void SystemContacts::set_friction(double coefficient) {
  friction_ = coefficient;
  with_bodies_.set_friction(coefficient);
  if (of_cords_) of_cords_->set_friction(coefficient);
  if (of_bodies_) of_bodies_->set_friction(coefficient);
}

void SystemContacts::set_reference_step(double dt) {
  reference_step_ = dt;
  with_bodies_.set_reference_step(dt);
  if (of_cords_) of_cords_->set_reference_step(dt);
  if (of_bodies_ && dt > 0) of_bodies_->fix_stiffness(dt);
}

void SystemContacts::forget_candidates() {
  with_bodies_.forget_candidates();
  if (of_cords_) of_cords_->forget_candidates();
}

void SystemContacts::look_around(TravelledWay& travelled, double dt) {
  const TravelledWay::Ways ways = travelled.take();
  last_way_ = ways.cords;
  with_bodies_.note_motion(ways.cords, ways.bodies);
  if (!of_cords_) return;
  of_cords_->note_way(ways.cords);
  of_cords_->look_around(state_.coordinates, elements_.lengths(), travelled.cord_speed(), dt, threads_.loop());
}

void SystemContacts::find(double cord_speed, double dt) {
  contacted_.clear();
  with_bodies_.find(state_.coordinates, state_.velocities, elements_.batch(), state_.bodies, cord_speed, dt,
                    contacted_);
  if (of_cords_)
    of_cords_->find(state_.coordinates, state_.velocities, elements_.lengths(), state_.last_step, dt, contacted_);
}

void SystemContacts::share_among(TiedCoordinates& ties) {
  if (contacted_.is_empty()) return ties.choose_none();
  ties.choose([this](std::span<const std::int32_t> copies) { return contacted_.share_among(copies); });
}

void SystemContacts::add_body_forces(const StepTimes& times, std::vector<Wrench>& wrenches) {
  if (!of_bodies_) return;
  of_bodies_->find(state_.bodies);
  of_bodies_->add_forces(state_.bodies, state_.controls, times, wrenches);
}

// Adds to the power of cords with bodies that of all other contacts.
SystemContacts::Power SystemContacts::with_others(Power power, const CoordinateVectors& velocities,
                                                  const std::vector<DynamicBody>& bodies) const {
  if (of_cords_) power += of_cords_->dissipated_power(velocities);
  if (of_bodies_) {
    const BodyContact::Power of_bodies = of_bodies_->power(bodies);
    power += Power{of_bodies.damping, of_bodies.friction};
  }
  return power;
}

SystemContacts::Power SystemContacts::power_before() const {
  return with_others(with_bodies_.dissipated_power_before(), state_.velocities, state_.bodies);
}

SystemContacts::Power SystemContacts::power(const CoordinateVectors& velocities,
                                            const std::vector<DynamicBody>& bodies) const {
  return with_others(with_bodies_.dissipated_power(velocities, bodies), velocities, bodies);
}

double SystemContacts::stored_energy() const {
  double energy = with_bodies_.stored_energy();
  if (of_cords_) energy += of_cords_->stored_energy();
  if (of_bodies_) energy += of_bodies_->stored_energy();
  return energy;
}

double SystemContacts::note_step(double kick, SafeguardCounts& safeguards) {
  for (std::size_t b = 0; b < impulses_.size(); ++b) {
    impulses_[b] += kick * with_bodies_.force_on(static_cast<std::int32_t>(b));
    if (of_bodies_) body_impulses_[b] += kick * of_bodies_->force_on(static_cast<std::int32_t>(b));
  }
  safeguards.stopped_blows += with_bodies_.stops();
  safeguards.unresolved_contacts += with_bodies_.unresolved();
  depths_.penetration = std::max(depths_.penetration, with_bodies_.deepest_penetration());
  depths_.pressed.keep_deeper(with_bodies_.deepest_part());
  if (!of_cords_) return 0;
  safeguards.stopped_cords += of_cords_->stops();
  safeguards.parted_overlaps += of_cords_->relaxed();
  depths_.overlapping.keep_deeper(of_cords_->deepest_part());
  return of_cords_->note_step();
}

void SystemContacts::visit_impulses(const std::function<void(double&)>& visit) {
  for (Eigen::Vector3d& impulse : impulses_) {
    for (double& component : impulse) visit(component);
  }
}

void SystemContacts::visit_springs(const std::function<void(double&)>& visit) {
  with_bodies_.visit_state(visit);
  if (of_cords_) of_cords_->visit_state(visit);
}

void SystemContacts::visit_bodies(const std::function<void(double&)>& visit) {
  if (!of_bodies_) return;
  for (Eigen::Vector3d& impulse : body_impulses_) {
    for (double& component : impulse) visit(component);
  }
  of_bodies_->visit_state(visit);
}

}  // namespace netpocket
