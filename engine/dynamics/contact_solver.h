#pragma once
// Contact of cables with rigid bodies: finds touching points of the elements, computes their forces and gives them to
// nodes, gradients and bodies by virtual work (S^T F).
//
// Each element is touched at a few points inside it, symmetric about its middle. A contact is as stiff as its partners'
// materials, but no stiffer than makes an impact at 1 m/s last eight steps: then the spring acts as in the leapfrog
// scheme, and the rebound is that of the law whatever the step (force_law.h).
//
// Contacts of a step see the same state and share the inertia of nodes (contacted_slots.h) and, counted likewise, of
// the body.

#include <array>
#include <span>
#include <vector>

#include "engine/bodies/sector_sum.h"
#include "engine/contact/broad_phase.h"
#include "engine/contact/force_law.h"
#include "engine/contact/surface_tracker.h"
#include "engine/dynamics/contacted_slots.h"
#include "engine/dynamics/dynamic_body.h"
#include "engine/dynamics/element_curve.h"
#include "engine/dynamics/slot_state.h"
#include "engine/model/model.h"

namespace netpocket {

class ContactSolver {
 public:
  ContactSolver(const Model& model, const SlotLayout& layout);

  // To be called when positions have changed other than by steps: candidates are looked for anew.
  void forget_candidates();
  void set_friction(double coefficient) { settings_.friction = coefficient; }

  // Finds the contacts at this state and enters them in `contacted`. `element_length`: current material length by
  // element (m). `dt` (s): step over which the forces will act.
  void find(const SlotVectors& coordinates, const SlotVectors& velocities, const std::vector<double>& element_length,
            const std::vector<DynamicBody>& bodies, double dt, ContactedSlots& contacted);

  // Adds the forces of the contacts found on slots to `applied` and on bodies to `wrenches` (by body, about the dynamic
  // body's centre of mass). Contact meets the velocities that `contacted` predicts, so that a cord at rest presses with
  // just what loads it.
  void add_forces(const SlotVectors& velocities, const ContactedSlots& contacted, std::span<const double> inverse_mass,
                  const std::vector<DynamicBody>& bodies, double dt, SlotVectors& applied,
                  std::vector<Wrench>& wrenches);

  // Power that the contacts take out of the motion at these velocities (W); positive when they dissipate.
  double dissipated_power(const SlotVectors& velocities, const std::vector<DynamicBody>& bodies) const;
  // The same at the velocities given to add_forces.
  double dissipated_power() const;

  // Contacts that bear force.
  std::vector<ContactPoint> contacts() const;
  const Eigen::Vector3d& force_on(std::int32_t body) const { return body_force_[body]; }
  double deepest_penetration() const { return deepest_penetration_; }

 private:
  struct Sample {  // shape functions at one contact point for unit length
    double position1, gradient1, position2, gradient2;

    // Of the slots of an element of this length (m).
    ElementWeights weights(double length) const {
      return {position1, length * gradient1, position2, length * gradient2};
    }
  };
  struct Pair {           // an element and a body
    double stiffness;     // K of the materials, N/m^1.5
    double mass;          // m_eff, kg
    double law_step = 0;  // s, for which `law` holds
    NormalLaw law{};
  };
  struct Contact {
    std::int32_t element, body;
    ElementSlots slot;
    ElementWeights weight;
    Eigen::Vector3d point;   // m, on the cable's axis: where the force acts on both, so that their moments balance
    Eigen::Vector3d normal;  // outward from the body
    double penetration;      // m
    Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  // m/s, of the cable relative to the body, before the step
    Eigen::Vector3d force = Eigen::Vector3d::Zero();     // N, on the cable
  };
  struct BodySums {
    SectorSum<Eigen::Vector3d> force, torque;  // N, N m
  };
  void survey(const SlotVectors& coordinates, const SlotVectors& velocities, const std::vector<double>& element_length,
              const std::vector<DynamicBody>& bodies, double dt);
  // False when the state is lost: then there is nothing to look for.
  bool update_broad_phase(const SlotVectors& coordinates, const std::vector<double>& element_length,
                          const std::vector<DynamicBody>& bodies);
  void find_contacts(const SlotVectors& coordinates, const std::vector<double>& element_length,
                     const std::vector<DynamicBody>& bodies);
  // Least distance (m) of the element's contact points from the body's surface, less the cable's radius; a lower bound
  // of it where that is more than `reach`.
  double clearance(const SlotVectors& coordinates, double length, std::int32_t element, std::int32_t body,
                   const DynamicBody& dynamic, double reach);
  Pair make_pair(std::int32_t element, std::int32_t body) const;
  const NormalLaw& law(const Contact& contact, double dt);
  void set_force(Contact& contact, const SlotVectors& velocities, const ContactedSlots& contacted,
                 std::span<const double> inverse_mass, const DynamicBody& body, double dt);
  Eigen::Vector3d relative_velocity(const Contact& contact, const SlotVectors& velocities,
                                    const DynamicBody& body) const;

  const Model& model_;
  SlotLayout layout_;
  ContactSettings settings_;
  std::vector<Sample> samples_;
  std::vector<ElementSlots> slots_;                         // by element
  std::vector<double> radius_;                              // by element
  double damping_;                                          // alpha of force_law.h
  std::vector<std::vector<Pair>> pairs_;                    // by body, of the elements that have touched it
  std::vector<std::vector<std::int32_t>> pair_of_element_;  // by body, element: in pairs_, or -1
  std::vector<std::vector<std::uint8_t>> excluded_;         // by body, element: attached to it
  BroadPhase broad_phase_;
  std::vector<SurfaceTracker> trackers_;         // by body; its points: by element, sample
  std::vector<std::vector<std::int32_t>> near_;  // by body: elements that may touch it before the next survey
  // No element can come nearer to a body than approach_ grows: it is tested when that has grown by its last clearance.
  double approach_ = 0, approach_per_step_ = 0;  // m
  std::vector<std::vector<double>> due_;         // by body, element: value of approach_ at which it may touch, m
  std::vector<Contact> contacts_;
  std::vector<int> contacts_on_body_;
  int steps_to_survey_ = 0;
  std::vector<BodySums> sums_;  // by body; empty without contacts
  std::vector<Eigen::Vector3d> body_force_;
  double deepest_penetration_ = 0;
};

}  // namespace netpocket
