#pragma once
// A free rigid body, stepped in time by leapfrog. A kick changes the momenta from n-1/2 to n+1/2 by the forces at step
// n. Then a drift changes position and attitude from n to n+1.
//
// The attitude is integrated by splitting the energy of the free top:
//   |L|^2/(2 I_2) + sum over the axes 1 and 3 of (1/I_k - 1/I_2) (e_k.L)^2/2,
// with the principal moments in ascending order I_1 <= I_2 <= I_3. The exact flow of the first term rotates the body
// about the fixed vector L. Those of the other terms rotate it about its own principal axes. The composition is
// symmetric, so the step is symplectic, reversible and of second order. The angular momentum is constant to the last
// bit, the energy error stays bounded, and the motion of spheres and symmetric tops is exact. Sources: Dullweber,
// Leimkuhler & McLachlan (1997), J. Chem. Phys. 107, 5840, doi:10.1063/1.474310. Splitting into a symmetric part and a
// remainder: Touma & Wisdom (1994), Astron. J. 107, 1189, doi:10.1086/116931.
//
// World frame and SI units unless said otherwise. A value type, without any synchronisation of threads.

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "engine/math/symmetric_algebra.h"

namespace netpocket {

// All variables that change in time. In the leapfrog scheme position and attitude belong to step n, velocity and
// angular momentum to the adjacent half step.
struct RigidBodyState {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();            // m, centre of mass
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();            // m/s, of the centre of mass
  Eigen::Quaterniond attitude = Eigen::Quaterniond::Identity();  // unit, body axes to world axes
  Eigen::Vector3d angular_momentum = Eigen::Vector3d::Zero();    // kg m^2/s, about the centre of mass, world axes
};

class RigidBody {
 public:
  // `mass` in kg. `inertia` in kg m^2, about the centre of mass, body axes; it need not be diagonal. Throws
  // std::invalid_argument unless the mass is positive and the inertia is symmetric and positive definite.
  RigidBody(double mass, const Eigen::Matrix3d& inertia, const RigidBodyState& state = {});

  double mass() const { return mass_; }                        // kg
  const Eigen::Matrix3d& inertia() const { return inertia_; }  // kg m^2, body axes
  const RigidBodyState& state() const { return state_; }
  // Sets the state and normalises the attitude.
  void set_state(const RigidBodyState& state);
  // Restores an earlier state of a body to the last bit: does not normalise the attitude again.
  void restore(const RigidBodyState& state);

  const Eigen::Vector3d& position() const { return state_.position; }
  const Eigen::Vector3d& velocity() const { return state_.velocity; }
  const Eigen::Quaterniond& attitude() const { return state_.attitude; }
  const Eigen::Matrix3d& rotation() const { return rotation_; }  // body axes to world axes
  const Eigen::Vector3d& angular_momentum() const { return state_.angular_momentum; }
  const Eigen::Vector3d& angular_velocity() const { return angular_velocity_; }  // rad/s, world axes

  void set_velocity(const Eigen::Vector3d& velocity) { state_.velocity = velocity; }
  // Angular momentum (kg m^2/s, world axes) for an angular velocity (rad/s, world axes) at the present attitude.
  Eigen::Vector3d angular_momentum_of(const Eigen::Vector3d& angular_velocity) const;
  // Sets the angular momentum for an angular velocity (rad/s, world axes) at the present attitude.
  void set_angular_velocity(const Eigen::Vector3d& angular_velocity);

  // Changes the momenta by a force (N) and a torque about the centre of mass (N m), constant over `dt` (s), world axes.
  void kick(const Eigen::Vector3d& force, const Eigen::Vector3d& torque, double dt);
  // Moves and rotates the body over `dt` (s) with constant velocity and angular momentum.
  void drift(double dt);

  // Transform points (m) and directions between world and body axes.
  Eigen::Vector3d to_body(const Eigen::Vector3d& world_point) const {
    return symmetric_transposed_product(rotation_, world_point - state_.position);
  }
  Eigen::Vector3d to_world(const Eigen::Vector3d& body_point) const {
    return state_.position + symmetric_product(rotation_, body_point);
  }
  Eigen::Vector3d direction_to_world(const Eigen::Vector3d& body_direction) const {
    return symmetric_product(rotation_, body_direction);
  }

  // Velocity (m/s) of the material point of the body that is now at a world point.
  Eigen::Vector3d velocity_at(const Eigen::Vector3d& point) const {
    return state_.velocity + angular_velocity_.cross(point - state_.position);
  }

  // Change of a world point's speed along the unit vector `direction` by a unit impulse there in that direction (1/kg):
  // 1/m + (r x d).I^-1 (r x d).
  double inverse_mass_at(const Eigen::Vector3d& point, const Eigen::Vector3d& direction) const;

  double kinetic_energy() const;  // J, translation and rotation

  // I^-1 v in world axes. For an angular impulse v (N m s) it is the change of the angular velocity (rad/s).
  Eigen::Vector3d apply_inverse_inertia(const Eigen::Vector3d& v) const;

 private:
  void turn_freely(double dt);
  void turn_about_principal_axis(int axis, double dt);
  void turn_about_angular_momentum(double dt);
  void update_rotation();

  double mass_;
  Eigen::Matrix3d inertia_;
  Eigen::Matrix3d principal_axes_;  // columns, body axes
  double middle_inverse_inertia_;   // 1/I_2
  Eigen::Vector3d excess_;          // 1/I_k - 1/I_2; zero for k = 2
  RigidBodyState state_;
  Eigen::Matrix3d rotation_;              // of state_.attitude
  Eigen::Matrix3d world_principal_axes_;  // columns
  Eigen::Vector3d angular_velocity_;
};

}  // namespace netpocket
