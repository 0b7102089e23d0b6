#pragma once
// Contact of nets, ropes and rods with each other. Cords are chains of capsules (cord_polyline.h). Where two capsules
// overlap, the law of force_law.h pushes them apart and Coulomb friction resists their sliding.
//
// Forces act on the ends of both capsules and are distributed to nodes and gradients by virtual work. The normal force
// acts along the line between the nearest points of the axes. Friction acts at the surface, so it also bends the cords.
// Its twisting part is left out, because the elements have no torsion. To this end friction is resolved along the two
// axes, and each component acts at the other cord's axis, where it twists neither cord. All forces and moments on the
// pair are balanced. Parallel cords would have to roll; they do so freely.
//
// Stiffness. At most what the run's first step resolves (resolved_stiffness). It is constant during the run, because
// springs that hold energy must not change with the step. Contacts that appear deep begin relaxed (cord_offsets.h).
//
// Least distance. Within a step no contact lets the axes come nearer to each other than a quarter of the sum of the
// radii. A faster approach is stopped there, at the price of a slower rebound. So cords do not pass through each other
// at any speed that a run's steps can follow.
//
// Symmetry. All contacts of a step see the same state and share the nodes' inertia (contacted_coordinates.h). The order
// of summation is the same in every sector of a pocket, and a pair's forces do not depend on which of the two comes
// first. So a symmetric pocket stays symmetric to the last bit.

#include <array>
#include <functional>
#include <span>
#include <vector>

#include "engine/contact/force_law.h"
#include "engine/dynamics/assembly/applied_forces.h"
#include "engine/dynamics/contact/contact_depth.h"
#include "engine/dynamics/contact/contact_kernel.h"
#include "engine/dynamics/contact/contacted_coordinates.h"
#include "engine/dynamics/contact/cord_offsets.h"
#include "engine/dynamics/contact/cord_pairs.h"
#include "engine/dynamics/contact/cord_polyline.h"
#include "engine/dynamics/contact/cord_search.h"
#include "engine/model/model.h"

namespace netpocket {

class CordContact {
 public:
  // `coordinates`: the model as built. `inverse_mass`: by coordinate.
  CordContact(const Model& model, const CoordinateLayout& layout, const CoordinateVectors& coordinates,
              std::span<const double> inverse_mass);
  CordContact(const CordContact&) = delete;
  CordContact& operator=(const CordContact&) = delete;

  // To be called when positions have changed in another way than by a step: after a displacement or a restored state.
  void forget_candidates() { search_.forget(); }
  void set_friction(double coefficient) { settings_.friction = coefficient; }
  // Step (s) that the stiffness of all contacts is based on.
  void set_reference_step(double dt) { reference_step_ = dt; }

  // See CordSearch::note_way.
  void note_way(double way) { search_.note_way(way); }
  // Updates the search. To be called at every step before find, with the same state and `dt` (s). `cord_speed`: upper
  // bound (m/s) of the speed of any point of a cord.
  void look_around(const CoordinateVectors& coordinates, const std::vector<double>& element_length, double cord_speed,
                   double dt, const DividedLoop& loop);

  // Finds the contacts at this state and enters them in `contacted`. `element_length`: present material length by
  // element (m). `last_step` and `dt`: the step (s) that led to this state, and the one over which the forces will act.
  void find(const CoordinateVectors& coordinates, const CoordinateVectors& velocities,
            const std::vector<double>& element_length, double last_step, double dt, ContactedCoordinates& contacted);

  // Adds the forces of the contacts found to `applied`. The forces oppose the velocities that `contacted` predicts.
  void add_forces(const CoordinateVectors& velocities, const ContactedCoordinates& contacted,
                  std::span<const double> inverse_mass, const StepTimes& times, AppliedForces& applied);

  // To be called when the step of the contacts found is taken. Returns the energy (J) of springs that yield in it.
  double note_step();

  // Energy in the springs (J) at the state that find was given.
  double stored_energy() const;
  // Power that the contacts take out of the motion at these velocities, besides what their springs store.
  contact_kernel::ContactPower dissipated_power(const CoordinateVectors& velocities) const;
  // Number of contacts found that are relaxed: they have appeared deep in the overlap, or have been pressed beyond the
  // greatest depth of their springs (kDeepImpact in cord_contact.cpp).
  std::int64_t relaxed() const { return relaxed_; }
  // Number of contacts in the last add_forces whose approach was stopped within the step.
  std::int64_t stops() const { return stops_; }
  // The deepest overlap relative to the sum of the radii.
  ContactDepth deepest_part() const;
  // Number of contacts that bear force.
  int count() const;
  // Whether the last find() has found any, with force or without.
  bool has_found_any() const { return !contacts_.empty(); }
  // Whether look_around() would look at coordinates; whether it and find() could find any contact.
  bool is_due(double cord_speed, double dt) const { return search_.is_due(reach_ahead(cord_speed, dt)); }
  bool may_find_any(double cord_speed, double dt) const { return is_due(cord_speed, dt) || !search_.near().empty(); }
  // Sum of the normal forces, N.
  double total_normal_force() const;

  // Gives every number of the state to `visit`, which may change it.
  void visit_state(const std::function<void(double&)>& visit) { offsets_.visit_state(visit); }

 private:
  using Weights = ElementWeights;

  // One of the two capsules in contact.
  struct Side {
    std::int32_t element;
    ElementIndices coordinate;
    std::array<Weights, 2> end;            // shape functions at the capsule's ends
    Weights point;                         // shape functions at the axis point nearest to the other capsule
    double fraction;                       // position of that point between the ends, 0 to 1
    double radius, length;                 // m, of the capsule; the length is at least the radius
    Eigen::Vector3d tangent;               // direction of the axis without its component along the normal
    std::array<Eigen::Vector3d, 2> force;  // N, on the ends
  };
  struct Contact {
    std::array<Side, 2> side;
    Eigen::Vector3d normal;  // unit vector from the second to the first
    double distance;         // m, between the axes
    double reach;            // m, sum of the radii
    CordOffsets::Place place;
    double stiffness;     // K, N/m^1.5
    double offset;        // m, overlap at which the spring begins
    double deepest;       // m, compression beyond which the spring yields
    double normal_force;  // N
    double elastic;       // N, of the spring alone

    double overlap() const { return reach - distance; }
    double compression() const { return overlap() - offset; }  // m, of the spring
    bool yields() const { return compression() > deepest; }
    // Energy in the spring, J. One that yields has not been pressed farther than its greatest depth.
    double stored_energy() const { return elastic_energy({stiffness, 0}, std::min(compression(), deepest)); }
  };
  struct Velocities {  // m/s, of the first side relative to the second
    Eigen::Vector3d point;
    std::array<Eigen::Vector3d, 2> spread;  // by side: of its first end relative to its second
  };

  double reach_ahead(double cord_speed, double dt) const;
  bool is_least(const NearSegments& near, bool second, double fraction, const Eigen::Vector3d& separation,
                const CoordinateVectors& coordinates, const std::vector<double>& element_length) const;
  void test(const NearSegments& near, const CoordinateVectors& coordinates, const std::vector<double>& element_length);
  void set_offset(Contact& contact, const NearSegments& near, double entered);
  Side make_side(std::int32_t element, std::int32_t segment, double fraction, double length) const;
  CordOffsets::Capsule capsule_of(std::int32_t element, std::int32_t segment) const;
  double material_stiffness(std::int32_t first, std::int32_t second) const;
  template <typename Vectors>
  Velocities relative_velocity(const Contact& contact, const Vectors& velocities) const;
  void set_forces(Contact& contact, const CoordinateVectors& velocities, const ContactedCoordinates& contacted,
                  std::span<const double> inverse_mass, const StepTimes& times);
  std::array<double, 2> friction(const Contact& contact, const Velocities& velocity,
                                 const ContactedCoordinates& contacted, std::span<const double> inverse_mass,
                                 double axis_inverse_mass, const StepTimes& times) const;
  // Calls function(side, corner) for every node and gradient of every contact. The order at any one coordinate is the
  // same in every sector.
  template <typename Function>
  void for_each_corner(const Function& function) const;

  const Model& model_;
  ContactSettings settings_;
  double damping_;  // alpha of force_law.h
  double reference_step_ = 0;
  double ahead_ = 0;  // m, gap within which cords may need to be stopped in the coming step
  std::int64_t relaxed_ = 0, stops_ = 0;
  CordPolyline polyline_;
  CordPairs pairs_;
  CordSearch search_;
  std::vector<std::int32_t> previous_, next_;     // by element: the element before and after it on its cord, or -1
  std::vector<CordPolyline::Vertices> vertices_;  // by search_.near_elements()
  CordOffsets offsets_;
  std::vector<Contact> contacts_;
  std::vector<std::int32_t> contact_of_near_;  // by search_.near(): index into contacts_, or -1
};

}  // namespace netpocket
