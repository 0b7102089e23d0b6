#pragma once
// A rigid body of a model during a run, with the nodes and gradients attached to it. Their lumped mass moves with the
// body, so the body and its attachments are stepped as one rigid body.

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

// What equal sectors around the y axis exert on a body on it together, from what one of them exerts.
inline Wrench of_all_sectors(const Wrench& of_one, int sectors) {
  if (sectors == 1) return of_one;
  return {{0, sectors * of_one.force.y(), 0}, {0, sectors * of_one.torque.y(), 0}};
}

// What acts on a body from outside, until it is changed.
struct BodyControl {
  Eigen::Vector3d force = Eigen::Vector3d::Zero();     // N, at `point`
  Eigen::Vector3d point = Eigen::Vector3d::Zero();     // m, from the own centre of mass, body axes
  std::array<std::optional<double>, 3> velocity = {};  // m/s, prescribed components of the velocity, world axes
  bool hold_attitude = false;                          // whether the angular velocity is prescribed, by `spin`
  Eigen::Vector3d spin = Eigen::Vector3d::Zero();      // rad/s, prescribed angular velocity if hold_attitude
  Wrench at_centre = {};  // additional, about the centre of mass of the body with its attachments

  // Adds what another source asks of the body, whose attitude is given. Wrenches add up. Where both prescribe a
  // component of the motion, `other` rules.
  void add(const BodyControl& other, const Eigen::Quaterniond& attitude);
  // Gives every number to `visit`, which may change it.
  void visit_state(const std::function<void(double&)>& visit);
};

// Motion of a body with its attachments: of its centre of mass, world axes.
struct RigidMotion {
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();          // m/s
  Eigen::Vector3d angular_velocity = Eigen::Vector3d::Zero();  // rad/s
};

class DynamicBody {
 public:
  struct Attachment {
    std::int32_t coordinate;
    bool direction;         // whether it is a gradient, which rotates with the body
    Eigen::Vector3d local;  // position from the common centre of mass (m), or the gradient; body axes
  };

  // `body`: index into Model::bodies. `mass`: lumped mass by coordinate.
  DynamicBody(const Model& model, std::int32_t body, const CoordinateLayout& layout, std::span<const double> mass);

  RigidBody& rigid() { return rigid_; }
  const RigidBody& rigid() const { return rigid_; }
  const std::vector<Attachment>& attachments() const { return attachments_; }

  RigidMotion motion() const { return {rigid_.velocity(), rigid_.angular_velocity()}; }
  // Wrench of the control in the last step, about the common centre of mass: what it was told to exert, and what
  // prescribing the motion required.
  const Wrench& exerted() const { return exerted_; }

  // Keeps the mass that all attachments have brought, but moves only these from now on.
  void reduce_attachments(std::vector<Attachment> attachments) { attachments_ = std::move(attachments); }

  void note_exerted(const Wrench& exerted) { exerted_ = exerted; }
  // Mean motion over the last kick: the work of a wrench is its product with that and the kick.
  const RigidMotion& mean_motion() const { return mean_motion_; }

  // State of the body without attachments.
  BodyState state() const;
  // Centre of mass of the body without attachments, world frame, m.
  Eigen::Vector3d centre() const { return rigid_.to_world(centre_); }

  // Sets positions and velocities of the attached coordinates from those of the body.
  void move_attachments(CoordinateVectors& coordinates, CoordinateVectors& velocities) const;
  // Wrench, about the common centre of mass, of a generalised force (N, N m) on an attached coordinate.
  Wrench attachment_wrench(const Attachment& attachment, const Eigen::Vector3d& force) const;

  // Kicks by `wrench` and the control over `kick` (s), then drifts by `drift` (s). Returns the work (J) of the control.
  double step(const Wrench& wrench, const BodyControl& control, double kick, double drift);
  // Kinetic energy (J) after `half_kick` (s) from now, half of a kick.
  double kinetic_energy_after(const Wrench& wrench, const BodyControl& control, double half_kick) const;
  // The body after a kick of `kick` (s) from now.
  RigidBody after(const Wrench& wrench, const BodyControl& control, double kick) const;
  // Change of the motion by an impulse (N s, N m s about the centre of mass) where the control leaves it free: velocity
  // of the centre of mass (m/s) and angular velocity (rad/s).
  struct Motion {
    Eigen::Vector3d velocity, spin;
  };
  Motion response(const Wrench& impulse, const BodyControl& control) const;
  // 1/kg and 1/(kg m^2). A unit impulse at a distance r from the centre of mass changes the velocity of its point by at
  // most inverse_mass() + r^2 largest_inverse_inertia().
  double inverse_mass() const { return inverse_mass_; }
  double largest_inverse_inertia() const { return largest_inverse_inertia_; }
  // Smallest effective mass (kg) of any point of the body's surface against a push along the surface normal.
  double least_mass() const { return least_mass_; }

  // A body without attachments, as its motion is stepped. `centre`: its own, from that of `rigid`, body axes, m.
  DynamicBody(const RigidBody& rigid, const Eigen::Vector3d& centre, const Shape& shape);

 private:
  Wrench total(const Wrench& wrench, const BodyControl& control, double kick) const;

  RigidBody rigid_;
  Eigen::Vector3d centre_;  // of the body without attachments, from the common centre of mass, body axes
  std::vector<Attachment> attachments_;
  Wrench exerted_;
  RigidMotion mean_motion_;
  double inverse_mass_;
  double largest_inverse_inertia_;
  double least_mass_;
};

}  // namespace netpocket
