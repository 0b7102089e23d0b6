#pragma once
// Contact of cables with rigid bodies: finds touching points of the elements, computes their forces and gives them to
// nodes, gradients and bodies by virtual work (S^T F).
//
// Each element is touched at a few points inside it, symmetric about its middle. A contact is as stiff as its partners'
// materials, but no stiffer than makes an impact at 1 m/s last eight steps: then the spring acts as in the leapfrog
// scheme, and the rebound is that of the law whatever the step (force_law.h).
//
// All contacts of a step are computed from the same state (Jacobi-wise). Where a contact is solved for its own speed
// (damping, friction, springs too stiff for the step), those that share nodes must share the nodes' inertia too: a
// contact's inverse mass counts every contact point on its nodes, w = sum_i S_i (sum_c S_i,c)/m_i + n_body w_body, the
// row sum of the contacts' common inverse mass matrix. No step can then push a node or a body beyond what a single
// contact would (mass splitting: Tonge, Benevolenski & Voroshilov 2012, doi:10.1145/2185520.2185601).

#include <array>
#include <functional>
#include <span>
#include <vector>

#include "engine/contact/broad_phase.h"
#include "engine/contact/force_law.h"
#include "engine/contact/surface_tracker.h"
#include "engine/dynamics/dynamic_body.h"
#include "engine/dynamics/slot_state.h"
#include "engine/model/model.h"

namespace netpocket {

class ContactSolver {
 public:
  ContactSolver(const Model& model, const SlotLayout& layout, std::span<const double> mass);

  // To be called when positions have changed other than by steps: candidates are looked for anew.
  void forget_candidates();
  void set_friction(double coefficient) { settings_.friction = coefficient; }

  // Finds the contacts at this state and adds their forces on slots to `applied` and on bodies to `wrenches` (by body,
  // about the dynamic body's centre of mass). `dt` (s): step over which the forces will act.
  // `element_length`: current material length by element (m). `free_acceleration`: of a slot by everything else in this
  // step; contact meets the velocity that results from it, so that a cord at rest presses with just what loads it.
  void add_forces(const SlotVectors& coordinates, const SlotVectors& velocities, std::span<const double> inverse_mass,
                  const std::vector<double>& element_length, const std::vector<DynamicBody>& bodies, double dt,
                  const std::function<Eigen::Vector3d(std::int32_t slot)>& free_acceleration, SlotVectors& applied,
                  std::vector<Wrench>& wrenches);

  // Slots that the last add_forces touched.
  const std::vector<std::int32_t>& touched_slots() const { return touched_slots_; }

  // Power that the contacts take out of the motion at these velocities (W); positive when they dissipate.
  double dissipated_power(const SlotVectors& velocities, const std::vector<DynamicBody>& bodies) const;

  // Contacts of the last add_forces that bear force.
  std::vector<ContactPoint> contacts() const;
  const Eigen::Vector3d& force_on(std::int32_t body) const { return body_force_[body]; }
  double deepest_penetration() const { return deepest_penetration_; }

 private:
  struct Sample {  // shape functions at one contact point for unit length
    double position1, gradient1, position2, gradient2;

    // Of the slots of an element of this length (m).
    std::array<double, 4> weights(double length) const {
      return {position1, length * gradient1, position2, length * gradient2};
    }
  };
  struct Pair {        // an element and a body
    double stiffness;  // K of the materials, N/m^1.5
    double mass;       // m_eff, kg
  };
  struct Contact {
    std::int32_t element, body;
    std::array<std::int32_t, 4> slot;
    std::array<double, 4> weight;
    Eigen::Vector3d point;   // m, on the cable's axis: where the force acts on both, so that their moments balance
    Eigen::Vector3d normal;  // outward from the body
    double penetration;      // m
    Eigen::Vector3d force = Eigen::Vector3d::Zero();  // N, on the cable
  };
  void survey(const SlotVectors& coordinates, const SlotVectors& velocities, const std::vector<double>& element_length,
              const std::vector<DynamicBody>& bodies, double dt);
  Eigen::AlignedBox3d bounds(const SlotVectors& coordinates, double length, std::int32_t element) const;
  // False when the state is lost: then there is nothing to look for.
  bool update_broad_phase(const SlotVectors& coordinates, const std::vector<double>& element_length,
                          const std::vector<DynamicBody>& bodies);
  void find(const SlotVectors& coordinates, const std::vector<double>& element_length,
            const std::vector<DynamicBody>& bodies);
  // Least distance (m) of the element's contact points from the body's surface, less the cable's radius; a lower bound
  // of it where that is more than `reach`.
  double clearance(const SlotVectors& coordinates, double length, std::int32_t element, std::int32_t body,
                   const DynamicBody& dynamic, double reach);
  void share_inertia();
  NormalLaw law(const Contact& contact, double dt) const;
  void set_force(Contact& contact, const SlotVectors& velocities, std::span<const double> inverse_mass,
                 const DynamicBody& body, double dt) const;
  Eigen::Vector3d relative_velocity(const Contact& contact, const SlotVectors& velocities,
                                    const DynamicBody& body) const;

  const Model& model_;
  SlotLayout layout_;
  ContactSettings settings_;
  std::vector<Sample> samples_;
  std::vector<std::array<std::int32_t, 4>> slots_;   // by element
  std::vector<double> radius_;                       // by element
  double damping_;                                   // alpha of force_law.h
  std::vector<std::vector<Pair>> pairs_;             // by body, element
  std::vector<std::vector<std::uint8_t>> excluded_;  // by body, element: attached to it
  BroadPhase broad_phase_;
  std::vector<SurfaceTracker> trackers_;         // by body; its points: by element, sample
  std::vector<std::vector<std::int32_t>> near_;  // by body: elements that may touch it before the next survey
  // No element can come nearer to a body than approach_ grows: it is tested when that has grown by its last clearance.
  double approach_ = 0, approach_per_step_ = 0;  // m
  std::vector<std::vector<double>> due_;         // by body, element: value of approach_ at which it may touch, m
  std::vector<Contact> contacts_;
  std::vector<double> shared_weight_;  // by slot, sum of contact weights
  SlotVectors predicted_;              // velocities of touched slots without contact
  std::vector<std::int32_t> touched_slots_;
  std::vector<int> contacts_on_body_;
  int steps_to_survey_ = 0;
  std::vector<Eigen::Vector3d> body_force_;
  double deepest_penetration_ = 0;
};

}  // namespace netpocket
