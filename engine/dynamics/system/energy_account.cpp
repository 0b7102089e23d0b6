#include "engine/dynamics/system/energy_account.h"

#include <algorithm>

namespace netpocket {

void EnergyAccount::begin() {
  initial_input_ = 0;
  const EnergyAudit start = make_audit();
  initial_energy_ = start.kinetic + start.strain + start.contact;
  initial_input_ = start.input;
  forget_audit();
}

void EnergyAccount::before_step(double kick) {
  power_before_ = contacts_.power_before();
  fed_to_contacts_ = contacts_.fed_power();
  spent_.at_hinges += sectors_ * (kick * forces_.hinge_power());
  ropes_change_ = elements_.ropes().energy_change(state_.coordinates, state_.velocities);
  if (forces_.tide()) tidal_before_ = tidal_power(state_.velocities);
}

void EnergyAccount::after_coordinates(double kick) {
  input_ += sectors_ * (kick * (forces_.element_power().fed + fed_to_contacts_));
  spent_.in_cords += sectors_ * (kick * (forces_.element_power().dissipated + forces_.line_power()));
  ropes_change_ += elements_.ropes().energy_change(state_.coordinates, state_.velocities);
  input_ -= sectors_ * (0.5 * ropes_change_);
  if (forces_.tide()) tidal_ += 0.5 * kick * (tidal_before_ + tidal_power(state_.velocities));
}

// Neither energy is negative, apart from round-off.
void EnergyAccount::after_bodies(double kick) {
  const SystemContacts::Power after = contacts_.power(state_.velocities, state_.bodies);
  spent_.in_contacts += sectors_ * std::max(0.5 * kick * (power_before_.damping + after.damping), 0.0);
  spent_.by_friction += sectors_ * std::max(0.5 * kick * (power_before_.friction + after.friction), 0.0);
  for (std::size_t b = 0; forces_.tide() && b < state_.bodies.size(); ++b) {
    tidal_ += kick * tidal_power(b, state_.bodies[b].mean_motion());
  }
}

// W, on free coordinates at these velocities, and on a body in this motion.
double EnergyAccount::tidal_power(const CoordinateVectors& velocity) const {
  return integrator_.power(forces_.tide()->accelerations(), velocity);
}
double EnergyAccount::tidal_power(std::size_t body, const RigidMotion& motion) const {
  const Wrench& wrench = forces_.tide()->wrench(body);
  return wrench.force.dot(motion.velocity) + wrench.torque.dot(motion.angular_velocity);
}

// J, over the first half of the step that the forces act for, at the end of which coordinates have this velocity.
double EnergyAccount::tidal_work_of_half(const CoordinateVectors& velocity) const {
  const double half_kick = 0.5 * state_.last_step;
  double power = tidal_power(state_.velocities) + tidal_power(velocity);
  for (std::size_t b = 0; b < state_.bodies.size(); ++b) {
    const DynamicBody& body = state_.bodies[b];
    const RigidBody later = body.after(forces_.wrenches()[b], state_.controls[b], half_kick);
    power += tidal_power(b, body.motion()) + tidal_power(b, {later.velocity(), later.angular_velocity()});
  }
  return 0.5 * half_kick * power;
}

// J, of bodies at the end of their half kick, and of nodes and gradients at the given velocities.
double EnergyAccount::kinetic_energy(const CoordinateVectors& velocity) const {
  double energy = 0;
  for (std::size_t b = 0; b < state_.bodies.size(); ++b) {
    if (const LockedBodies* lock = state_.lock_of(b)) {
      if (lock->carrier() != static_cast<std::int32_t>(b)) continue;
      energy +=
          lock->kinetic_energy_after(state_.bodies, forces_.wrenches(), state_.controls[b], 0.5 * state_.last_step);
      continue;
    }
    energy += state_.bodies[b].kinetic_energy_after(forces_.wrenches()[b], state_.controls[b], 0.5 * state_.last_step);
  }
  return energy + sectors_ * integrator_.kinetic_energy(velocity);
}

// Power at the velocities that the present forces lead to.
SystemContacts::Power EnergyAccount::contact_power_after(double kick) {
  CoordinateVectors positions = state_.coordinates, velocity = integrator_.velocities_after(kick);
  std::vector<DynamicBody> moving = state_.bodies;
  for (const LockedBodies& lock : state_.locks) {
    if (!lock.is_locked()) continue;
    lock.kick(moving, forces_.wrenches(), state_.controls[static_cast<std::size_t>(lock.carrier())], kick);
  }
  for (std::size_t b = 0; b < moving.size(); ++b) {
    if (state_.lock_of(b) == nullptr) {
      moving[b].rigid() = state_.bodies[b].after(forces_.wrenches()[b], state_.controls[b], kick);
    }
    moving[b].move_attachments(positions, velocity);
  }
  return contacts_.power(velocity, moving);
}

EnergyAudit EnergyAccount::audit() {
  if (!is_audited()) last_audit_ = make_audit();
  audited_ = forces_.computations();
  return last_audit_;
}

EnergyAudit EnergyAccount::make_audit() {
  const double half_kick = 0.5 * state_.last_step;
  element_states_.refresh();
  const CoordinateVectors velocity = integrator_.velocities_after(half_kick);
  RopeDynamics& ropes = elements_.ropes();
  const RopeDynamics::FlowEnergy flow = ropes.flow_energy(state_.coordinates, velocity);
  EnergyAudit result;
  result.kinetic = kinetic_energy(velocity) + sectors_ * flow.kinetic;
  result.aliased = sectors_ * integrator_.aliased_energy(velocity);
  result.strain = forces_.line_energy() +
                  sectors_ * forces_.with_hinge_energy(forces_.wrinkling_energy() + element_states_.strain_energy());
  if (!ring_ropes_.empty()) result.strain += ring_ropes_.energy();
  const SystemContacts::Power before = contacts_.power_before(), after = contact_power_after(state_.last_step);
  // Energy of the first half of the step that the forces act for, in which the power has changed by half of its change.
  // At most that of the whole step: where a contact rebounds within the step, its first half alone dissipates more.
  const auto first_half = [half_kick](double power, double later) {
    return std::clamp(half_kick * (0.75 * power + 0.25 * later), 0.0, std::max(half_kick * (power + later), 0.0));
  };
  result.contact = sectors_ * contacts_.stored_energy();
  result.spent = spent_;
  result.spent.in_cords += sectors_ * (half_kick * (forces_.element_power().dissipated + forces_.line_power()));
  result.spent.at_hinges += sectors_ * (half_kick * forces_.hinge_power());
  result.spent.in_contacts += sectors_ * first_half(before.damping, after.damping);
  result.spent.by_friction += sectors_ * first_half(before.friction, after.friction);
  result.input = input_ + sectors_ * (half_kick * (forces_.element_power().fed + contacts_.fed_power())) +
                 forces_.load_work() + sectors_ * flow.work -
                 sectors_ * (0.5 * ropes.energy_change(state_.coordinates, state_.velocities)) - initial_input_;
  if (forces_.tide()) {
    result.tidal = tidal_ + tidal_work_of_half(velocity);
    result.input += result.tidal;
  }
  result.error =
      result.kinetic + result.strain + result.contact + result.spent.total() - result.input - initial_energy_;
  return result;
}

void EnergyAccount::visit_state(const std::function<void(double&)>& visit) {
  for (double* value : {&input_, &spent_.in_cords, &spent_.at_hinges, &spent_.in_contacts, &spent_.by_friction,
                        &initial_energy_, &initial_input_}) {
    visit(*value);
  }
  if (forces_.tide()) visit(tidal_);
}

}  // namespace netpocket
