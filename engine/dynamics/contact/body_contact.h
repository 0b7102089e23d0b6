#pragma once
// Contact of rigid bodies with each other, with the force law that also applies to cords (contact/force_law.h), at the
// places that contact/shape_pair.h finds.
//
// Stiffness. A pair has the stiffness of its materials, limited so that an impact at 1 m/s lasts sixteen of the first
// step. Bodies are few and large, so they are resolved better than cords. The limit uses the smallest mass at any point
// of their surfaces. The stiffness is constant during a run: the spring's energy is the same function of the
// penetration for all steps. It is part of the state.
//
// Shared inertia. All places of a step see the same state. The inverse mass of a place counts the effect of all places
// together, each in proportion to its spring's force.
//
// World frame. Thread contract: one thread at a time. The places and their order are the same for any number of
// threads.

#include <functional>
#include <span>
#include <vector>

#include "engine/contact/force_law.h"
#include "engine/contact/shape_pair.h"
#include "engine/dynamics/assembly/dynamic_body.h"
#include "engine/model/model.h"

namespace netpocket {

class BodyContact {
 public:
  // Considers all pairs of the model's bodies. `bodies`: by body, with their attachments.
  BodyContact(const Model& model, std::span<const DynamicBody> bodies);

  void set_friction(double coefficient) { settings_.friction = coefficient; }
  // Fixes the stiffness for a run with a first step of `dt` (s). Without this call, each step has the stiffness that it
  // resolves.
  void fix_stiffness(double dt);

  // Finds the contact places at the bodies' present positions.
  void find(std::span<const DynamicBody> bodies);
  // Adds the forces over the coming step to `wrenches` (by body), which must already hold all other forces.
  void add_forces(std::span<const DynamicBody> bodies, std::span<const BodyControl> controls, const StepTimes& times,
                  std::vector<Wrench>& wrenches);

  // Energy (J) in the springs of the places found.
  double stored_energy() const;
  // Power (W) that the forces of the last add_forces take out of the motion at the bodies' present velocities. The mean
  // of the values before and after a step is not negative.
  struct Power {
    double damping = 0;  // by the dampers
    double friction = 0;
    double total() const { return damping + friction; }
  };
  Power power(std::span<const DynamicBody> bodies) const;

  int count() const { return static_cast<int>(places_.size()); }
  double deepest_penetration() const;                                                // m
  double total_normal_force() const;                                                 // N
  const Eigen::Vector3d& force_on(std::int32_t body) const { return force_[body]; }  // N, of the last add_forces
  // Appends each place twice, with the force on either body, with element -1.
  void append_points(std::vector<ContactPoint>& points) const;

  // Gives every number of the state to `visit`, which may change it.
  void visit_state(const std::function<void(double&)>& visit);

 private:
  struct Pair {
    std::int32_t first, second;
    ShapePair shapes;
    double material_stiffness;  // N/m^1.5
    double least_mass;          // kg, smallest effective mass that a contact point can have
    double stiffness = 0;       // N/m^1.5; 0: not yet fixed
  };
  struct Place {
    const Pair* pair;
    Touch touch;
    Eigen::Vector3d first_arm, second_arm;               // m, from the bodies' centres of mass
    double stiffness = 0;                                // N/m^1.5
    double elastic = 0;                                  // N, of the spring alone
    double normal = 0;                                   // N, total normal force
    Eigen::Vector3d friction = Eigen::Vector3d::Zero();  // N, on the first body

    Eigen::Vector3d force() const { return normal * touch.normal + friction; }  // N, on the first body
  };
  // What the forces of one step depend on.
  struct Step {
    std::span<const DynamicBody> bodies;
    std::span<const BodyControl> controls;
    StepTimes times;
  };

  static double stiffness_of(const Pair& pair, double dt);
  template <typename Force>
  std::vector<Wrench> sum_by_body(const Force& force) const;
  template <typename Direction>
  std::vector<double> shared_inverse_masses(const Step& step, const Direction& direction) const;
  static Eigen::Vector3d relative_velocity(const Place& place, const RigidBody& first, const RigidBody& second);
  std::vector<RigidBody> after(const Step& step, std::span<const Wrench> wrenches) const;
  void set_normal_forces(const Step& step, std::span<const Wrench> others);
  void set_friction_forces(const Step& step, std::span<const Wrench> others);

  ContactSettings settings_;
  double damping_;  // alpha of force_law.h
  std::vector<TouchableShape> shapes_;
  std::vector<Pair> pairs_;
  std::vector<Place> places_;
  std::vector<Touch> touches_;
  std::vector<Eigen::Vector3d> force_;  // by body
};

}  // namespace netpocket
