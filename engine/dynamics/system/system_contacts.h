#pragma once
// All contacts of a system: cords with bodies, cords with each other, bodies with each other. Internal to this room.

#include <memory>
#include <vector>

#include "engine/dynamics/assembly/applied_forces.h"
#include "engine/dynamics/assembly/safeguards.h"
#include "engine/dynamics/contact/body_contact.h"
#include "engine/dynamics/contact/contact_depth.h"
#include "engine/dynamics/contact/contact_solver.h"
#include "engine/dynamics/contact/contacted_coordinates.h"
#include "engine/dynamics/contact/cord_contact.h"
#include "engine/dynamics/system/cable_elements.h"
#include "engine/dynamics/system/cable_state.h"
#include "engine/dynamics/system/system_threads.h"
#include "engine/dynamics/system/travelled_way.h"

namespace netpocket {

class SystemContacts {
 public:
  using Power = contact_kernel::ContactPower;

  // All must outlive this object.
  SystemContacts(const Model& model, const CableElements& elements, const CableState& state,
                 const SystemThreads& threads, int sectors = 1);

  double friction() const { return friction_; }
  void set_friction(double coefficient);
  // Step (s) that the stiffness of contacts is based on; 0: not yet known.
  double reference_step() const { return reference_step_; }
  void set_reference_step(double dt);
  // Whether springs are as stiff as steps of `dt` (s) need; see ContactSolver.
  bool fits(double dt) const { return with_bodies_.fits(dt); }
  void fit_stiffness(double dt) { with_bodies_.fit_stiffness(dt, state_.bodies); }
  double largest_load() { return with_bodies_.largest_load(state_.bodies); }
  // To be called when positions have changed in another way than by a step.
  void forget_candidates();

  // The parts of a step's forces, in this order. All contacts are found before any of them exerts a force, so that all
  // see the same state.
  // Tells the searches what has moved, and lets cords look for each other.
  void look_around(TravelledWay& travelled, double dt);
  void find(double cord_speed, double dt);
  // Forces on cords, and on bodies from cords. `sum_forces`(blocks, rows): all other forces on blocks of coordinates.
  template <typename SumForces>
  void add_cord_forces(const StepTimes& times, const SumForces& sum_forces, AppliedForces& applied,
                       std::vector<Wrench>& wrenches) {
    contacted_.predict(state_.velocities, elements_.inverse_mass(), times.kick, sum_forces);
    with_bodies_.add_forces(state_.velocities, contacted_, elements_.inverse_mass(), state_.bodies, times, applied,
                            wrenches);
    if (of_cords_) {
      of_cords_->add_forces(state_.velocities, contacted_, elements_.inverse_mass(), times, applied);
    }
  }
  // In a model that is one sector: copies of a node share the contacts on all of them. To be called after find().
  void share_among(TiedCoordinates& ties);
  // Upper bound (m) of the way of any point of a cord, by which look_around() has been told that they have moved.
  double last_way() const { return last_way_; }
  // Forces between bodies. `wrenches` must hold all other forces, whose motion these depend on.
  void add_body_forces(const StepTimes& times, std::vector<Wrench>& wrenches);
  // Whether what controls bodies takes part in the present forces.
  bool depend_on_controls() const { return of_bodies_ && of_bodies_->count() > 0; }

  // Power (W) that the present forces take out of the motion, besides what springs store: at the velocities that they
  // were computed for, and at others.
  Power power_before() const;
  Power power(const CoordinateVectors& velocities, const std::vector<DynamicBody>& bodies) const;
  // J, in springs: of all contacts, and of cords with bodies alone.
  double stored_energy() const;
  double energy_with_bodies() const { return with_bodies_.stored_energy(); }
  // Power (W) that winding puts into springs of contacts.
  double fed_power() const { return with_bodies_.fed_power(state_.coordinates, elements_.batch()); }

  // To be called in a step whose kick (s) applies the present forces: adds up impulses, counts safeguards, keeps
  // depths. Returns the energy (J) of springs that yield in the step.
  double note_step(double kick, SafeguardCounts& safeguards);

  const ContactSolver& with_bodies() const { return with_bodies_; }
  const CordContact* of_cords() const { return of_cords_.get(); }    // null: cords pass through each other
  const BodyContact* of_bodies() const { return of_bodies_.get(); }  // null: bodies pass through each other
  // N s since the start, by body: from cords, and from other bodies.
  const Eigen::Vector3d& impulse(std::int32_t body) const { return impulses_[body]; }
  const Eigen::Vector3d& body_impulse(std::int32_t body) const { return body_impulses_[body]; }
  ContactDepths& depths() { return depths_; }

  // Give numbers of the state to `visit`, which may change them: the impulses from cords; the springs; what bodies do
  // to each other.
  void visit_impulses(const std::function<void(double&)>& visit);
  void visit_springs(const std::function<void(double&)>& visit);
  void visit_bodies(const std::function<void(double&)>& visit);

 private:
  Power with_others(Power power, const CoordinateVectors& velocities, const std::vector<DynamicBody>& bodies) const;

  const CableElements& elements_;
  const CableState& state_;
  const SystemThreads& threads_;
  double friction_;
  double reference_step_ = 0;
  ContactSolver with_bodies_;
  std::unique_ptr<CordContact> of_cords_;
  std::unique_ptr<BodyContact> of_bodies_;
  ContactedCoordinates contacted_;
  double last_way_ = 0;
  std::vector<Eigen::Vector3d> impulses_, body_impulses_;
  ContactDepths depths_;
};

}  // namespace netpocket
