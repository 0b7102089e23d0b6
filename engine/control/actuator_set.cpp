#include "engine/control/actuator_set.h"

namespace netpocket {

ActuatorSet::ActuatorSet(const Scenario& scenario)
    : limits_force_(scenario.actuators.kind != ActuatorKind::ideal),
      limits_torque_(limits_force_ || !scenario.wheels.empty()) {
  const ActuatorParameters& actuators = scenario.actuators;
  if (actuators.kind == ActuatorKind::thrusters) {
    std::vector<Thruster> thrusters;
    for (const ThrusterParameters& thruster : scenario.thrusters) {
      thrusters.push_back(
          {thruster.position, thruster.direction, thruster.thrust, actuators.impulse_bit, actuators.specific_impulse});
    }
    thrusters_.emplace(thrusters, actuators.time_constant);
  } else {
    WrenchBoxSettings settings{.specific_impulse = actuators.specific_impulse};
    if (actuators.kind == ActuatorKind::box) {
      settings.most_force = actuators.most_force;
      settings.most_torque = actuators.most_torque;
      settings.time_constant = actuators.time_constant;
    }
    box_.emplace(settings);
  }
  std::vector<ReactionWheel> wheels;
  for (const WheelParameters& wheel : scenario.wheels) {
    wheels.push_back({wheel.axis, wheel.most_torque, wheel.most_momentum});
  }
  if (!wheels.empty()) wheels_.emplace(wheels);
}

void ActuatorSet::command(const Wrench& wanted, const Eigen::Vector3d& angular_velocity, double period) {
  Wrench rest = wanted;
  if (wheels_) {
    wheels_->command(wanted.torque + angular_velocity.cross(wheels_->momentum()));
    rest.torque.setZero();
  }
  if (box_) {
    box_->command(rest);
  } else {
    thrusters_->command(rest, period);
  }
}

Wrench ActuatorSet::step(const Eigen::Vector3d& angular_velocity, double dt) {
  Wrench exerted = box_ ? box_->step(dt) : thrusters_->step(dt);
  if (wheels_) exerted += wheels_->step(angular_velocity, dt);
  return exerted;
}

double ActuatorSet::torque_load() const {
  if (wheels_) return wheels_->load();
  return box_ ? box_->torque_load() : thrusters_->load();
}

double ActuatorSet::propellant() const { return box_ ? box_->propellant() : thrusters_->propellant(); }

const std::vector<double>& ActuatorSet::momenta() const {
  static const std::vector<double> kNone;
  return wheels_ ? wheels_->wheel_momenta() : kNone;
}

void ActuatorSet::visit_state(const NumberVisitor& visit) {
  if (box_) box_->visit_state(visit);
  if (thrusters_) thrusters_->visit_state(visit);
  if (wheels_) wheels_->visit_state(visit);
}

}  // namespace netpocket
