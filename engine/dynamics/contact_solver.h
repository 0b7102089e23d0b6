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
#include <optional>
#include <span>
#include <vector>

#include "engine/bodies/sector_sum.h"
#include "engine/contact/broad_phase.h"
#include "engine/contact/force_law.h"
#include "engine/contact/surface_tracker.h"
#include "engine/dynamics/applied_forces.h"
#include "engine/dynamics/contact_kernel.h"
#include "engine/dynamics/contacted_slots.h"
#include "engine/dynamics/dynamic_body.h"
#include "engine/dynamics/element_curve.h"
#include "engine/dynamics/motion_bound.h"
#include "engine/dynamics/slot_state.h"
#include "engine/model/model.h"

namespace netpocket {

class ContactSolver {
 public:
  ContactSolver(const Model& model, const SlotLayout& layout);

  // To be called when positions have changed other than by steps: candidates are looked for anew.
  void forget_candidates();
  void set_friction(double coefficient) { settings_.friction = coefficient; }

  // Finds the contacts at this state and enters them in `contacted`. `batch`: the model's elements with their present
  // lengths. `dt` (s): step over which the forces will act.
  void find(const SlotVectors& coordinates, const SlotVectors& velocities, const ElementBatch& batch,
            const std::vector<DynamicBody>& bodies, double dt, ContactedSlots& contacted);

  // Adds the forces of the contacts found on slots to `applied` and on bodies to `wrenches` (by body, about the dynamic
  // body's centre of mass). Contact meets the velocities that `contacted` predicts, so that a cord at rest presses with
  // just what loads it.
  void add_forces(const SlotVectors& velocities, const ContactedSlots& contacted, std::span<const double> inverse_mass,
                  const std::vector<DynamicBody>& bodies, double dt, AppliedForces& applied,
                  std::vector<Wrench>& wrenches);

  // Power that the contacts take out of the motion at these velocities (W); positive when they dissipate.
  double dissipated_power(const SlotVectors& velocities, const std::vector<DynamicBody>& bodies) const;
  // The same at the velocities given to add_forces.
  double dissipated_power() const;

  // Contacts that bear force.
  std::vector<ContactPoint> contacts() const;
  const Eigen::Vector3d& force_on(std::int32_t body) const { return body_force_[body]; }
  double deepest_penetration() const { return deepest_penetration_; }  // m
  struct Depth {
    std::int32_t element, body;
    double penetration;  // m
  };
  std::optional<Depth> deepest_contact() const;

 private:
  struct Pairs {                   // the elements of a block and a body
    double stiffness[kBlockSize];  // K of the materials, N/m^1.5
    double mass[kBlockSize];       // m_eff, kg
    double law_step = 0;           // s, for which the law holds
    NormalLaw law[kBlockSize];
  };
  struct BodySums {
    SectorSum<Eigen::Vector3d> force, torque;  // N, N m
  };
  // What concerns one body.
  struct Partner {
    double bounding_radius;  // m
    bool is_sphere;
    SurfaceTracker tracker;               // its points: by element, sample
    std::vector<std::uint8_t> touchable;  // by block of elements: a bit for each lane
    std::vector<double> due;              // by block: value of approach_ at which it may touch, m
    std::vector<std::int32_t> pairs;      // by block: in pairs_, or -1
    std::vector<std::int32_t> near;       // blocks that may touch it before the next survey, ascending
    std::size_t first = 0, last = 0;      // in contacts_
    int contacts = 0;
  };
  void survey(const SlotVectors& coordinates, const SlotVectors& velocities, const ElementBatch& batch,
              const std::vector<DynamicBody>& bodies, double dt);
  double fastest(const SlotVectors& velocities, const std::vector<DynamicBody>& bodies) const;
  template <typename Function>
  void for_each_rope_element(const ElementBatch& batch, const Function& function) const;
  // Bound of the way (m) of any point of a cord since the broad phase was built.
  double way_since_built(const SlotVectors& coordinates, const ElementBatch& batch) const;
  // False when the state is lost: then there is nothing to look for.
  bool update_broad_phase(const SlotVectors& coordinates, const ElementBatch& batch,
                          const std::vector<DynamicBody>& bodies);
  void update_near(std::int32_t body, double margin, const SlotVectors& coordinates, const ElementBatch& batch,
                   const DynamicBody& dynamic);
  // Least distance (m) of a block's contact points from the body's surface, less the cables' radius; a lower bound of
  // it where that is more than `margin`. Calls touch(element, lane, sample, point, nearest surface point) where it is
  // negative.
  template <typename Touch>
  double clearance(std::int32_t block, std::int32_t body, double margin, const SlotVectors& coordinates,
                   const ElementBatch& batch, const DynamicBody& dynamic, const Touch& touch);
  void find_contacts(std::int32_t body, const SlotVectors& coordinates, const ElementBatch& batch,
                     const DynamicBody& dynamic, double dt);
  void add_contact(std::int32_t body, const ElementBlock& block, std::int32_t element, std::size_t sample,
                   const Eigen::Vector3d& point, const Eigen::Vector3d& normal, double penetration,
                   const NormalLaw& law);
  Pairs make_pairs(std::int32_t block, std::int32_t body) const;
  const NormalLaw* laws(std::int32_t block, std::int32_t body, double dt);
  template <typename Function>
  void for_each_contact(const Function& function) const;

  const Model& model_;
  SlotLayout layout_;
  ContactSettings settings_;
  std::vector<contact_kernel::Sample> samples_;
  std::vector<double> thickest_;  // by block of elements, m
  double damping_;                // alpha of force_law.h
  std::vector<Pairs> pairs_;      // that have touched
  BroadPhase broad_phase_;
  MotionBound motion_;
  SlotVectors built_coordinates_;          // when the broad phase was built
  std::vector<double> built_rope_length_;  // m, of ropes' elements, likewise
  std::vector<Partner> partners_;          // by body
  // No element can come nearer to a body than approach_ grows: it is tested when that has grown by its last clearance.
  double approach_ = 0, approach_per_step_ = 0;  // m
  AlignedVector<double> points_;                 // of one block
  AlignedVector<ContactBlock> contacts_;         // by body
  int steps_to_survey_ = 0;
  std::vector<Eigen::Vector3d> body_force_;
  double deepest_penetration_ = 0;
};

}  // namespace netpocket
