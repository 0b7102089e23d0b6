#include "engine/dynamics/assembly/dynamic_body.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include "engine/math/sector_sum.h"
#include "engine/math/symmetric_algebra.h"

namespace netpocket {
namespace {

// Inertia of a point mass at `a`: m (|a|^2 I - a a^T).
Eigen::Matrix3d point_inertia(double mass, const Eigen::Vector3d& a) {
  return mass * (symmetric_squared_norm(a) * Eigen::Matrix3d::Identity() - a * a.transpose());
}

struct AttachedMass {
  std::int32_t coordinate;
  bool direction;
  double mass;
  Eigen::Vector3d local;  // position from the body's own centre of mass, or the gradient; body axes
};

std::vector<AttachedMass> attached_masses(const Model& model, std::int32_t body, const CoordinateLayout& layout,
                                          std::span<const double> mass) {
  const BodyState& state = model.bodies[body].state;
  const Eigen::Matrix3d rotation = state.attitude.toRotationMatrix();
  std::vector<AttachedMass> list;
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    if (model.nodes[i].support != Support::body || model.nodes[i].body != body) continue;
    const std::int32_t coordinate = layout.position(static_cast<std::int32_t>(i));
    list.push_back({coordinate, false, mass[coordinate],
                    symmetric_transposed_product(rotation, model.nodes[i].position - state.position)});
  }
  for (std::size_t i = 0; i < model.gradients.size(); ++i) {
    if (model.gradients[i].support != Support::body || model.gradients[i].body != body) continue;
    const std::int32_t coordinate = layout.gradient(static_cast<std::int32_t>(i));
    list.push_back(
        {coordinate, true, mass[coordinate], symmetric_transposed_product(rotation, model.gradients[i].value)});
  }
  return list;
}

// The model's body and its attached masses as one rigid body. `centre` receives the own centre of mass of the model's
// body, relative to the common one.
RigidBody compound(const ModelBody& body, const std::vector<AttachedMass>& attached, Eigen::Vector3d& centre) {
  double mass = body.mass;
  SectorSum<Eigen::Vector3d> moment(Eigen::Vector3d::Zero());
  for (const AttachedMass& a : attached) {
    if (a.direction) continue;
    mass += a.mass;
    moment.add(a.coordinate, a.mass * a.local);
  }
  centre = -moment.total() / mass;
  SectorSum<Eigen::Matrix3d> inertia(Eigen::Matrix3d::Zero());
  for (const AttachedMass& a : attached) {
    inertia.add(a.coordinate, point_inertia(a.mass, a.direction ? a.local : Eigen::Vector3d(a.local + centre)));
  }
  RigidBody rigid(mass, body.inertia + inertia.total() + point_inertia(body.mass, centre));
  RigidBodyState state;
  state.attitude = body.state.attitude.normalized();
  rigid.set_state(state);
  state.position = body.state.position - rigid.direction_to_world(centre);
  state.velocity = body.state.velocity - body.state.angular_velocity.cross(rigid.direction_to_world(centre));
  rigid.set_state(state);
  rigid.set_angular_velocity(body.state.angular_velocity);
  return rigid;
}

// Upper bound (1/kg) of the inverse mass of any point of a shape centred at `centre`, in any direction. The largest
// eigenvalue of 1/M + [a]^T I^-1 [a] is a convex function of the arm a, so it is largest at a corner of the shape's
// bounding box. Normals of a sphere pass through its centre, so for a sphere the arm is that of the centre.
double largest_inverse_mass(const RigidBody& rigid, const Eigen::Vector3d& centre, const Shape& shape) {
  Eigen::AlignedBox3d box = extents(shape);
  if (std::holds_alternative<Sphere>(shape)) box = Eigen::AlignedBox3d(Eigen::Vector3d::Zero());
  double largest = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3d arm = centre + box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner));
    Eigen::Matrix3d cross;
    cross << 0, -arm.z(), arm.y(), arm.z(), 0, -arm.x(), -arm.y(), arm.x(), 0;
    const Eigen::Matrix3d turning = cross.transpose() * rigid.inertia().ldlt().solve(cross);
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(turning, Eigen::EigenvaluesOnly);
    largest = std::max(largest, solver.eigenvalues().maxCoeff());
  }
  return 1 / rigid.mass() + largest;
}

}  // namespace

// The other force is moved to this point, where the couple (P2 - P1) x F2 makes up for it.
void BodyControl::add(const BodyControl& other, const Eigen::Quaterniond& attitude) {
  const Eigen::Vector3d arm = attitude * (other.point - point);
  at_centre += other.at_centre;
  at_centre.torque += arm.cross(other.force);
  force += other.force;
  for (std::size_t axis = 0; axis < velocity.size(); ++axis) {
    if (other.velocity[axis]) velocity[axis] = other.velocity[axis];
  }
  if (!other.hold_attitude) return;
  hold_attitude = true;
  spin = other.spin;
}

void BodyControl::visit_state(const std::function<void(double&)>& visit) {
  const auto visit_flag = [&](bool flag) {
    double number = flag ? 1 : 0;
    visit(number);
    return number != 0;
  };
  for (Eigen::Vector3d* vector : {&force, &point, &spin, &at_centre.force, &at_centre.torque}) {
    for (double& component : *vector) visit(component);
  }
  for (std::optional<double>& component : velocity) {
    const bool prescribed = visit_flag(component.has_value());
    double value = component.value_or(0);
    visit(value);
    component = prescribed ? std::optional(value) : std::nullopt;
  }
  hold_attitude = visit_flag(hold_attitude);
}

DynamicBody::DynamicBody(const RigidBody& rigid, const Eigen::Vector3d& centre, const Shape& shape)
    : rigid_(rigid),
      centre_(centre),
      inverse_mass_(1 / rigid.mass()),
      least_mass_(1 / largest_inverse_mass(rigid, centre, shape)) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(rigid.inertia(), Eigen::EigenvaluesOnly);
  largest_inverse_inertia_ = 1 / solver.eigenvalues().minCoeff();
}

DynamicBody::DynamicBody(const Model& model, std::int32_t body, const CoordinateLayout& layout,
                         std::span<const double> mass)
    : DynamicBody([&] {
        const auto attached = attached_masses(model, body, layout, mass);
        Eigen::Vector3d centre;
        const RigidBody rigid = compound(model.bodies[body], attached, centre);
        DynamicBody result(rigid, centre, model.bodies[body].shape);
        for (const AttachedMass& a : attached) {
          result.attachments_.push_back(
              {a.coordinate, a.direction, a.direction ? a.local : Eigen::Vector3d(a.local + centre)});
        }
        return result;
      }()) {}

BodyState DynamicBody::state() const {
  const Eigen::Vector3d point = centre();
  return {point, rigid_.attitude(), rigid_.velocity_at(point), rigid_.angular_velocity()};
}

void DynamicBody::move_attachments(CoordinateVectors& coordinates, CoordinateVectors& velocities) const {
  for (const Attachment& a : attachments_) {
    const Eigen::Vector3d arm = rigid_.direction_to_world(a.local);
    coordinates.set(a.coordinate, a.direction ? arm : Eigen::Vector3d(rigid_.position() + arm));
    const Eigen::Vector3d spin = rigid_.angular_velocity().cross(arm);
    velocities.set(a.coordinate, a.direction ? spin : Eigen::Vector3d(rigid_.velocity() + spin));
  }
}

Wrench DynamicBody::attachment_wrench(const Attachment& attachment, const Eigen::Vector3d& force) const {
  const Eigen::Vector3d arm = rigid_.direction_to_world(attachment.local);
  return {attachment.direction ? Eigen::Vector3d::Zero() : force, arm.cross(force)};
}

Wrench DynamicBody::total(const Wrench& wrench, const BodyControl& control, double kick) const {
  const Eigen::Vector3d arm = rigid_.direction_to_world(centre_ + control.point);
  Wrench sum = wrench + Wrench{control.force, arm.cross(control.force)} + control.at_centre;
  for (int i = 0; i < 3; ++i) {
    if (control.velocity[i] && kick > 0)
      sum.force[i] = rigid_.mass() * (*control.velocity[i] - rigid_.velocity()[i]) / kick;
  }
  if (control.hold_attitude)
    sum.torque = (rigid_.angular_momentum_of(control.spin) - rigid_.angular_momentum()) / (kick > 0 ? kick : 1);
  return sum;
}

double DynamicBody::step(const Wrench& wrench, const BodyControl& control, double kick, double drift) {
  const Wrench sum = total(wrench, control, kick);
  exerted_ = {sum.force - wrench.force, sum.torque - wrench.torque};
  const Eigen::Vector3d velocity = rigid_.velocity(), spin = rigid_.angular_velocity();
  rigid_.kick(sum.force, sum.torque, kick);
  mean_motion_ = {0.5 * (velocity + rigid_.velocity()), 0.5 * (spin + rigid_.angular_velocity())};
  const double work =
      kick * (exerted_.force.dot(mean_motion_.velocity) + exerted_.torque.dot(mean_motion_.angular_velocity));
  rigid_.drift(drift);
  return work;
}

double DynamicBody::kinetic_energy_after(const Wrench& wrench, const BodyControl& control, double half_kick) const {
  RigidBody body = rigid_;
  const Wrench sum = total(wrench, control, 2 * half_kick);
  body.kick(sum.force, sum.torque, half_kick);
  return body.kinetic_energy();
}

RigidBody DynamicBody::after(const Wrench& wrench, const BodyControl& control, double kick) const {
  RigidBody body = rigid_;
  const Wrench sum = total(wrench, control, kick);
  body.kick(sum.force, sum.torque, kick);
  return body;
}

DynamicBody::Motion DynamicBody::response(const Wrench& impulse, const BodyControl& control) const {
  Motion motion{inverse_mass_ * impulse.force, rigid_.apply_inverse_inertia(impulse.torque)};
  for (int i = 0; i < 3; ++i) {
    if (control.velocity[i]) motion.velocity[i] = 0;
  }
  if (control.hold_attitude) motion.spin.setZero();
  return motion;
}

}  // namespace netpocket
