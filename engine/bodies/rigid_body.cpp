#include "engine/bodies/rigid_body.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "engine/math/rotation.h"

namespace netpocket {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// Largest angle (rad) of one substep of the splitting, and the largest number of substeps in a step. The relative error
// of the rotational energy oscillates with an amplitude of about (angle/20)^2.
constexpr double kLargestTurn = 0.001, kMostTurns = 64;

void check(double mass, const Matrix3d& inertia) {
  if (!(mass > 0 && std::isfinite(mass))) throw std::invalid_argument("a rigid body needs a positive mass");
  if (!inertia.allFinite() || !inertia.isApprox(inertia.transpose(), 1e-12))
    throw std::invalid_argument("a rigid body needs a symmetric inertia matrix");
}

}  // namespace

RigidBody::RigidBody(double mass, const Matrix3d& inertia, const RigidBodyState& state)
    : mass_(mass), inertia_(inertia) {
  check(mass, inertia);
  const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(inertia);
  const Vector3d& moments = solver.eigenvalues();  // ascending
  if (!(moments[0] > 0)) throw std::invalid_argument("a rigid body needs a positive definite inertia matrix");
  principal_axes_ = solver.eigenvectors();
  middle_inverse_inertia_ = 1 / moments[1];
  excess_ = moments.cwiseInverse().array() - middle_inverse_inertia_;
  set_state(state);
}

void RigidBody::set_state(const RigidBodyState& state) {
  state_ = state;
  state_.attitude.normalize();
  update_rotation();
}

void RigidBody::restore(const RigidBodyState& state) {
  state_ = state;
  update_rotation();
}

Vector3d RigidBody::angular_momentum_of(const Vector3d& angular_velocity) const {
  return symmetric_product(rotation_, inertia_ * symmetric_transposed_product(rotation_, angular_velocity));
}

void RigidBody::set_angular_velocity(const Vector3d& angular_velocity) {
  state_.angular_momentum = angular_momentum_of(angular_velocity);
  angular_velocity_ = apply_inverse_inertia(state_.angular_momentum);  // same bits as from a restored state
}

void RigidBody::kick(const Vector3d& force, const Vector3d& torque, double dt) {
  state_.velocity += (dt / mass_) * force;
  state_.angular_momentum += dt * torque;
  angular_velocity_ = apply_inverse_inertia(state_.angular_momentum);
}

void RigidBody::drift(double dt) {
  state_.position += dt * state_.velocity;
  // In a diverged state the angle is NaN; std::max then gives one substep.
  const double parts =
      std::min(kMostTurns, std::max(1.0, std::ceil(symmetric_norm(angular_velocity_) * dt / kLargestTurn)));
  for (int part = 0; part < static_cast<int>(parts); ++part) turn_freely(dt / parts);
  turn_about_angular_momentum(dt);  // commutes with the other turns
  state_.attitude.normalize();
  update_rotation();
}

void RigidBody::turn_freely(double dt) {
  turn_about_principal_axis(0, 0.5 * dt);
  turn_about_principal_axis(2, dt);
  turn_about_principal_axis(0, 0.5 * dt);
}

double RigidBody::inverse_mass_at(const Vector3d& point, const Vector3d& direction) const {
  const Vector3d arm = (point - state_.position).cross(direction);
  return 1 / mass_ + symmetric_dot(arm, apply_inverse_inertia(arm));
}

double RigidBody::kinetic_energy() const {
  return 0.5 * mass_ * symmetric_squared_norm(state_.velocity) +
         0.5 * symmetric_dot(angular_velocity_, state_.angular_momentum);
}

Vector3d RigidBody::apply_inverse_inertia(const Vector3d& v) const {
  const auto& first = world_principal_axes_.col(0);
  const auto& third = world_principal_axes_.col(2);
  return middle_inverse_inertia_ * v +
         (excess_[0] * symmetric_dot(first, v) * first + excess_[2] * symmetric_dot(third, v) * third);
}

void RigidBody::turn_about_principal_axis(int axis, double dt) {
  const Vector3d momentum = state_.attitude.conjugate() * state_.angular_momentum;  // body axes
  const double rate = excess_[axis] * symmetric_dot(principal_axes_.col(axis), momentum);
  state_.attitude = state_.attitude * rotation_by(dt * rate * principal_axes_.col(axis));
}

void RigidBody::turn_about_angular_momentum(double dt) {
  state_.attitude = rotation_by(dt * middle_inverse_inertia_ * state_.angular_momentum) * state_.attitude;
}

void RigidBody::update_rotation() {
  rotation_ = state_.attitude.toRotationMatrix();
  world_principal_axes_ = rotation_ * principal_axes_;
  angular_velocity_ = apply_inverse_inertia(state_.angular_momentum);
}

}  // namespace netpocket
