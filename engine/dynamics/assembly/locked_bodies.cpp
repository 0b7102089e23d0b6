#include "engine/dynamics/assembly/locked_bodies.h"

namespace netpocket {
namespace {

Eigen::Matrix3d inertia_about(const Eigen::Vector3d& arm, double mass) {
  return mass * (arm.squaredNorm() * Eigen::Matrix3d::Identity() - arm * arm.transpose());
}

// Of both bodies; its axes are those of the world at the start.
RigidBody whole(const RigidBody& a, const RigidBody& b) {
  const double mass = a.mass() + b.mass();
  const Eigen::Vector3d centre = (a.mass() * a.position() + b.mass() * b.position()) / mass;
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
  Eigen::Vector3d momentum = Eigen::Vector3d::Zero(), angular_momentum = Eigen::Vector3d::Zero();
  for (const RigidBody* body : {&a, &b}) {
    const Eigen::Vector3d arm = body->position() - centre;
    inertia += body->rotation() * body->inertia() * body->rotation().transpose() + inertia_about(arm, body->mass());
    momentum += body->mass() * body->velocity();
    angular_momentum += body->angular_momentum() + body->mass() * arm.cross(body->velocity());
  }
  inertia = 0.5 * (inertia + inertia.transpose()).eval();
  return RigidBody(mass, inertia, {centre, momentum / mass, Eigen::Quaterniond::Identity(), angular_momentum});
}

}  // namespace

LockedBodies::LockedBodies(const BodyLock& lock, const Model& model, const std::vector<DynamicBody>& bodies)
    : lock_(lock), together_([&] {
        const DynamicBody& carrier = bodies[static_cast<std::size_t>(lock.carrier)];
        const RigidBody rigid = whole(carrier.rigid(), bodies[static_cast<std::size_t>(lock.carried)].rigid());
        return DynamicBody(rigid, carrier.centre() - rigid.position(),
                           model.bodies[static_cast<std::size_t>(lock.carrier)].shape);
      }()) {
  Part* part = parts_;
  for (const std::int32_t index : {lock.carrier, lock.carried}) {
    const RigidBody& body = bodies[static_cast<std::size_t>(index)].rigid();
    *part++ = {index, body.position() - together_.rigid().position(), body.attitude()};
  }
}

// About the common centre of mass.
Wrench LockedBodies::sum(const std::vector<DynamicBody>& bodies, const std::vector<Wrench>& wrenches) const {
  Wrench total;
  for (const Part& part : parts_) {
    const auto index = static_cast<std::size_t>(part.body);
    const Eigen::Vector3d arm = bodies[index].rigid().position() - together_.rigid().position();
    total += Wrench{wrenches[index].force, wrenches[index].torque + arm.cross(wrenches[index].force)};
  }
  return total;
}

void LockedBodies::place(const RigidBody& together, std::vector<DynamicBody>& bodies) const {
  for (const Part& part : parts_) {
    RigidBody& body = bodies[static_cast<std::size_t>(part.body)].rigid();
    const Eigen::Vector3d position = together.to_world(part.local);
    body.set_state({position, together.velocity_at(position), together.attitude() * part.attitude, {0, 0, 0}});
    body.set_angular_velocity(together.angular_velocity());
  }
}

double LockedBodies::step(std::vector<DynamicBody>& bodies, const std::vector<Wrench>& wrenches,
                          const BodyControl& control, double kick, double drift) {
  const double work = together_.step(sum(bodies, wrenches), control, kick, drift);
  place(together_.rigid(), bodies);
  bodies[static_cast<std::size_t>(lock_.carrier)].note_exerted(together_.exerted());
  return work;
}

double LockedBodies::kinetic_energy_after(const std::vector<DynamicBody>& bodies, const std::vector<Wrench>& wrenches,
                                          const BodyControl& control, double half_kick) const {
  return together_.kinetic_energy_after(sum(bodies, wrenches), control, half_kick);
}

void LockedBodies::kick(std::vector<DynamicBody>& moving, const std::vector<Wrench>& wrenches,
                        const BodyControl& control, double kick) const {
  place(together_.after(sum(moving, wrenches), control, kick), moving);
}

void LockedBodies::visit_state(const std::function<void(double&)>& visit) {
  RigidBodyState state = together_.rigid().state();
  for (Eigen::Vector3d* vector : {&state.position, &state.velocity, &state.angular_momentum}) {
    for (double& component : *vector) visit(component);
  }
  for (double& component : state.attitude.coeffs()) visit(component);
  together_.rigid().restore(state);
  double locked = locked_ ? 1 : 0;
  visit(locked);
  locked_ = locked != 0;
}

}  // namespace netpocket
