#pragma once
// A rigid body of a model during a run, with the nodes and gradients that are attached to it. Their lumped mass moves
// with the body, so what is stepped is the body and its attachments as one.

#include <Eigen/Core>
#include <array>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "engine/bodies/rigid_body.h"
#include "engine/dynamics/assembly/coordinate_vectors.h"
#include "engine/model/model.h"

namespace netpocket {

struct Wrench {
  Eigen::Vector3d force = Eigen::Vector3d::Zero();   // N
  Eigen::Vector3d torque = Eigen::Vector3d::Zero();  // N m, about the centre of mass of the body with its attachments

  Wrench& operator+=(const Wrench& other) {
    force += other.force;
    torque += other.torque;
    return *this;
  }
  friend Wrench operator+(Wrench a, const Wrench& b) { return a += b; }
};

// What is imposed on a body from outside, until it is changed.
struct BodyControl {
  Eigen::Vector3d force = Eigen::Vector3d::Zero();     // N, at `point`
  Eigen::Vector3d point = Eigen::Vector3d::Zero();     // m, from the body's centre of mass, body axes
  std::array<std::optional<double>, 3> velocity = {};  // m/s, prescribed velocity components, world axes
  bool hold_attitude = false;                          // an attitude control takes the torque: no rotation, or `spin`
  Eigen::Vector3d spin = Eigen::Vector3d::Zero();      // rad/s, prescribed angular velocity where the attitude is held
  Wrench at_centre = {};                               // besides, about the centre of the body with its attachments

  // Gives every number to `visit`, which may change it.
  void visit_state(const std::function<void(double&)>& visit);
};

// Of a body with its attachments, at its centre of mass, world axes.
struct RigidMotion {
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();          // m/s
  Eigen::Vector3d angular_velocity = Eigen::Vector3d::Zero();  // rad/s
};

class DynamicBody {
 public:
  struct Attachment {
    std::int32_t coordinate;
    bool direction;         // a gradient: turns with the body
    Eigen::Vector3d local;  // m from the common centre of mass, or the gradient; body axes
  };

  // `mass` by coordinate.
  DynamicBody(const Model& model, std::int32_t body, const CoordinateLayout& layout, std::span<const double> mass);

  RigidBody& rigid() { return rigid_; }
  const RigidBody& rigid() const { return rigid_; }
  const std::vector<Attachment>& attachments() const { return attachments_; }

  RigidMotion motion() const { return {rigid_.velocity(), rigid_.angular_velocity()}; }
  // What the control exerted in the last step, about the centre of mass: what it was told to, and what it took to
  // prescribe the motion.
  const Wrench& exerted() const { return exerted_; }

  // State of the model's body itself, without attachments.
  BodyState state() const;
  // The model's body's centre of mass, world frame, m.
  Eigen::Vector3d centre() const { return rigid_.to_world(centre_); }

  // Sets positions and velocities of the attached coordinates from the body's.
  void move_attachments(CoordinateVectors& coordinates, CoordinateVectors& velocities) const;
  // Wrench of a generalised force on an attached coordinate.
  Wrench attachment_wrench(const Attachment& attachment, const Eigen::Vector3d& force) const;

  // Kicks by `wrench` and the control over `kick`, drifts by `drift` (s). Returns the work (J) that the control did.
  double step(const Wrench& wrench, const BodyControl& control, double kick, double drift);
  // Kinetic energy (J) after half a kick from now.
  double kinetic_energy_after(const Wrench& wrench, const BodyControl& control, double half_kick) const;
  // The body after a kick from now.
  RigidBody after(const Wrench& wrench, const BodyControl& control, double kick) const;
  // What an impulse (N s, N m s about the centre of mass) changes of its motion where the control leaves it free: speed
  // of the centre of mass (m/s) and angular velocity (rad/s).
  struct Motion {
    Eigen::Vector3d velocity, spin;
  };
  Motion response(const Wrench& impulse, const BodyControl& control) const;
  // A unit impulse at a distance r from the centre of mass changes the speed of its point by no more than
  // inverse_mass() + r^2 largest_inverse_inertia(): 1/kg, 1/(kg m^2).
  double inverse_mass() const { return inverse_mass_; }
  double largest_inverse_inertia() const { return largest_inverse_inertia_; }
  // kg, that any point of the body's surface has at least against a push along the surface's normal.
  double least_mass() const { return least_mass_; }

 private:
  DynamicBody(const RigidBody& rigid, const Eigen::Vector3d& centre, const Shape& shape);
  Wrench total(const Wrench& wrench, const BodyControl& control, double kick) const;

  RigidBody rigid_;
  Eigen::Vector3d centre_;  // of the model's body, from the common centre of mass, body axes
  std::vector<Attachment> attachments_;
  Wrench exerted_;
  double inverse_mass_;
  double largest_inverse_inertia_;
  double least_mass_;
};

}  // namespace netpocket
