#pragma once
// Contact of cables with rigid bodies. Computes the force at each place where a cord touches a body (contact_search.h)
// and distributes it to nodes, gradients and the body by virtual work (S^T F). Theory: THEORY.md, section 6.
//
// Stiffness. A contact has the stiffness of its materials, limited so that an impact at 1 m/s lasts eight steps of the
// run's first size. The limit uses the smallest mass that any point of the body can have. Where steps become less than
// a quarter as long, springs become stiffer. They keep their energy (spring_offsets.h).
//
// Greatest depth. A spring that is too soft for an impact would let the cord through. Each contact therefore has a
// greatest depth, at which the approach is stopped within one step.
//
// Shared inertia. All contacts of a step are computed from the same state. Contacts that share nodes or a body share
// their mass (contacted_coordinates.h), so that their sum does not overshoot.

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "engine/dynamics/assembly/applied_forces.h"
#include "engine/dynamics/assembly/coordinate_vectors.h"
#include "engine/dynamics/assembly/dynamic_body.h"
#include "engine/dynamics/contact/contact_blocks.h"
#include "engine/dynamics/contact/contact_depth.h"
#include "engine/dynamics/contact/contact_kernel.h"
#include "engine/dynamics/contact/contact_laws.h"
#include "engine/dynamics/contact/contact_search.h"
#include "engine/dynamics/contact/contacted_coordinates.h"
#include "engine/dynamics/contact/spring_offsets.h"
#include "engine/model/model.h"

namespace netpocket {

class ContactSolver {
 public:
  ContactSolver(const Model& model, const CoordinateLayout& layout);

  // To be called when positions have changed in another way than by a step: after a displacement or a restored state.
  void forget_candidates();
  // The model is one of this many equal sectors around the y axis (model/sector_model.h): what acts on a body acts on
  // it from each of them, and all share its inertia.
  void set_sectors(int sectors) { sectors_ = sectors; }
  void set_friction(double coefficient) { settings_.friction = coefficient; }
  // Step (s) that the stiffness of all contacts is for, as long as steps are not much shorter.
  void set_reference_step(double dt);

  // Whether the springs are as stiff as steps of `dt` (s) need. They always are while steps are longer than a quarter
  // of the reference step.
  bool fits(double dt) const { return stiffness_step_for(dt) == steps_.present; }
  // Adapts the springs to steps of `dt` (s). To be called after find() at the present state, which must then be called
  // again. Springs that become stiffer keep their energy. Springs that become softer may lose some.
  void fit_stiffness(double dt, const std::vector<DynamicBody>& bodies);

  // To be called after each step with upper bounds (m) of the distance that any point has moved in it: `cords` for
  // points of cords, bodies[b] for points of body b.
  void note_motion(double cords, std::span<const double> bodies);

  // Finds the contacts at this state and enters them in `contacted`. `batch`: the model's elements with their present
  // lengths. `dt`: the step (s) over which the forces will act. `cord_speed`: upper bound (m/s) of the speed of any
  // point of a cord at this state.
  void find(const CoordinateVectors& coordinates, const CoordinateVectors& velocities, const ElementBatch& batch,
            const std::vector<DynamicBody>& bodies, double cord_speed, double dt, ContactedCoordinates& contacted);

  // Adds the forces of the contacts found to `applied` (on coordinates) and to `wrenches` (by body, about the dynamic
  // body's centre of mass). The force opposes the velocities that `contacted` predicts for the end of the step, which
  // include all other forces. So a cord at rest presses with exactly the force that loads it.
  void add_forces(const CoordinateVectors& velocities, ContactedCoordinates& contacted,
                  std::span<const double> inverse_mass, const std::vector<DynamicBody>& bodies, const StepTimes& times,
                  AppliedForces& applied, std::vector<Wrench>& wrenches);

  // Energy in the springs (J) at the state that find was given.
  double stored_energy() const;
  // Power that the contacts take out of the motion, besides what their springs store: at the velocities that add_forces
  // was given, and at the given velocities.
  contact_kernel::ContactPower dissipated_power_before() const { return power_before_; }
  contact_kernel::ContactPower dissipated_power(const CoordinateVectors& velocities,
                                                const std::vector<DynamicBody>& bodies) const;

  // Power (W) that whoever changes the lengths of elements puts into the springs of contacts on them: the places of
  // contact move although the coordinates do not.
  double fed_power(const CoordinateVectors& coordinates, const ElementBatch& batch) const;

  // Contacts that bear force.
  std::vector<ContactPoint> contacts() const;
  bool has_contacts() const { return contacts_.size() > 0; }
  bool touches(std::int32_t body) const {
    const Partner& partner = partners_[static_cast<std::size_t>(body)];
    return partner.first != partner.last;
  }
  // Whether all springs are those of the reference step and begin at the surface.
  bool are_springs_plain() const;
  const Eigen::Vector3d& force_on(std::int32_t body) const { return body_force_[body]; }
  double deepest_penetration() const { return deepest_penetration_; }  // m
  // Compression (m) of the spring that is compressed most: the penetration where it begins at the surface.
  double largest_compression() const;
  // The deepest penetration relative to its cord's radius.
  const ContactDepth& deepest_part() const { return deepest_part_; }
  // Contacts that the present forces stop at their greatest depth.
  int stops() const { return stops_; }
  // Contacts whose spring is too stiff for the step (force_law.h: theta > 0).
  int unresolved() const { return unresolved_; }
  // Largest dt^2 w k of the present forces' springs, four times that of springs that bear much.
  double largest_squared_phase() const { return largest_squared_phase_; }
  // Largest force of a present spring by what the softest springs, those for the first step, bear at their greatest
  // compression.
  double largest_load(const std::vector<DynamicBody>& bodies);
  struct Depth {
    std::int32_t element, body;
    double penetration;  // m
  };
  std::optional<Depth> deepest_contact() const;

  // Gives every number of the state to `visit`, which may change it.
  void visit_state(const std::function<void(double&)>& visit);

 private:
  struct Partner {
    ContactSearch search;
    ContactLaws laws;
    SpringOffsets offsets;
    std::size_t first = 0, last = 0;              // range in contacts_
    std::size_t first_place = 0, last_place = 0;  // range in places_
    double shares = 0;                            // sum of its contacts' shares
    double way = 0;  // m, bound of what any point of a cord has approached the body by in the last step
  };
  contact_kernel::ContactPower power_of(std::size_t body, const CoordinateRows& velocities,
                                        const DynamicBody& dynamic) const;
  void find_contacts(std::int32_t body, const CoordinateVectors& coordinates, const CoordinateVectors& velocities,
                     const ElementBatch& batch, const DynamicBody& dynamic, double cord_speed, double dt);
  double stiffness_step_for(double dt) const;
  double way_ahead(std::int32_t body, const DynamicBody& dynamic, double cord_speed, double dt) const;
  // Whether a place that is still apart would touch the body within the step.
  bool hits_within_step(const CordTouch& touch, std::int32_t body, double length, const CoordinateVectors& velocities,
                        const DynamicBody& dynamic, double dt) const;
  // Enter places that search has found. `body_mass` (kg): smallest mass that any point of the body can have.
  void add_touches(std::int32_t body, double body_mass, const ElementBatch& batch);
  void add_sphere_touches(std::int32_t body, double body_mass, const ElementBatch& batch);
  void note_depth(std::int32_t body, double body_mass, std::int32_t element, std::int32_t part, bool is_cord_end,
                  double penetration);
  void note_depths(std::int32_t body, double body_mass, const TouchBlock& touch, const ContactBlock& block);
  void add_contact(std::int32_t body, double body_mass, const CordTouch& touch, double length, std::int32_t place);
  void list_places(std::size_t first_block);
  void apply_offsets(Partner& partner, double body_mass);
  ElementWeights weights_at(const CordTouch& touch, double length) const;
  // What the last forces of a body's contacts came to.
  struct Outcome {
    int stops = 0, unresolved = 0;
    double squared_phase = 0;
    contact_kernel::ContactPower power;  // valid only if no contact was stopped
  };
  Outcome outcome_of(const Partner& partner, double body_mass);
  double load_of(const ContactBlock& block, int lane, double body_mass);
  // Calls function(block, lane) in the order in which the contacts were found.
  template <typename Function>
  void for_each_contact(const Function& function) const {
    for (const std::int32_t place : places_) {
      function(contacts_[static_cast<std::size_t>(place / kBlockSize)], place % kBlockSize);
    }
  }
  std::span<const std::int32_t> places_of(const Partner& partner) const {
    return {places_.data() + partner.first_place, partner.last_place - partner.first_place};
  }

  const Model& model_;
  CordPolyline polyline_;
  ContactSettings settings_;
  int sectors_ = 1;
  SpringSteps steps_;                 // the present one is the reference step or a half, a quarter, ... of it
  std::vector<Partner> partners_;     // by body
  std::vector<CordTouch> touches_;    // of one body
  ContactBlocks contacts_;            // ordered by body
  std::vector<std::int32_t> places_;  // of the contacts in the order found: block * kBlockSize + lane
  mutable AlignedVector<contact_kernel::LanePowers> powers_;
  std::vector<Eigen::Vector3d> body_force_;
  double deepest_penetration_ = 0;
  ContactDepth deepest_part_;
  int stops_ = 0, unresolved_ = 0;
  double largest_squared_phase_ = 0;
  contact_kernel::ContactPower power_before_;
};

}  // namespace netpocket
