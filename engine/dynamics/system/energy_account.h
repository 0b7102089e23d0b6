#pragma once
// The account of a system's energy since the start: what was put in, what was spent, and what the audit finds left.
// Internal to this room.

#include <cstdint>
#include <functional>

#include "engine/dynamics/ropes/ring_ropes.h"
#include "engine/dynamics/system/cable_elements.h"
#include "engine/dynamics/system/cable_state.h"
#include "engine/dynamics/system/cable_system.h"
#include "engine/dynamics/system/element_states.h"
#include "engine/dynamics/system/leapfrog.h"
#include "engine/dynamics/system/system_contacts.h"
#include "engine/dynamics/system/system_forces.h"

namespace netpocket {

class EnergyAccount {
 public:
  // All must outlive this object. `sectors`: number of sectors of which the model is one; the account is of all.
  EnergyAccount(CableElements& elements, const CableState& state, const RingRopes& ring_ropes,
                const SystemContacts& contacts, const SystemForces& forces, ElementStates& element_states,
                Leapfrog& integrator, int sectors = 1)
      : elements_(elements),
        state_(state),
        ring_ropes_(ring_ropes),
        contacts_(contacts),
        forces_(forces),
        element_states_(element_states),
        integrator_(integrator),
        sectors_(sectors) {}

  // Begins the account at the present state, whose forces must be known. May be called again before the first step.
  void begin();

  // In a step, in this order, with the kick (s) of the present forces: before anything moves; when the free coordinates
  // have moved, which the power of the elements may wait for; when the bodies have, too.
  void before_step(double kick);
  void after_coordinates(double kick);
  void after_bodies(double kick);
  void add_input(double work) { input_ += work; }  // J
  void add_spent_in_contacts(double energy) { spent_.in_contacts += energy; }
  void add(const RingRopes::Work& work) {
    input_ += work.input;
    spent_.in_cords += work.in_dampers;
    spent_.by_friction += work.at_rings;
  }

  // The energies now. The present forces must be known.
  EnergyAudit audit();
  // Whether the last audit is that of the present forces.
  bool is_audited() const { return audited_ == forces_.computations() && forces_.are_current(); }
  // To be called when anything that the audit depends on has changed, besides the state and the forces.
  void forget_audit() { audited_ = -1; }

  // Gives every number to `visit`, which may change it.
  void visit_state(const std::function<void(double&)>& visit);

 private:
  double kinetic_energy(const CoordinateVectors& velocity) const;
  double tidal_power(const CoordinateVectors& velocity) const;
  double tidal_power(std::size_t body, const RigidMotion& motion) const;
  double tidal_work_of_half(const CoordinateVectors& velocity) const;
  SystemContacts::Power contact_power_after(double kick);
  EnergyAudit make_audit();

  CableElements& elements_;
  const CableState& state_;
  const RingRopes& ring_ropes_;
  const SystemContacts& contacts_;
  const SystemForces& forces_;
  ElementStates& element_states_;
  Leapfrog& integrator_;
  double sectors_;
  SpentEnergy spent_;
  double input_ = 0;                               // J, without loads
  double initial_energy_ = 0, initial_input_ = 0;  // J
  double ropes_change_ = 0;                        // J, RopeDynamics::energy_change before the step under way
  SystemContacts::Power power_before_;             // W, in the step under way
  double fed_to_contacts_ = 0;                     // W, likewise
  double tidal_ = 0;                               // J, work of the tide, which input_ does not hold
  double tidal_before_ = 0;                        // W, in the step under way, on coordinates
  EnergyAudit last_audit_;
  std::int64_t audited_ = -1;  // SystemForces::computations of last_audit_; -1: outdated
};

}  // namespace netpocket
