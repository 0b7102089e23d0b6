#include "engine/control/towing.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/math/elementary.h"

namespace netpocket {
namespace {

// Time constant (s) of the means of accelerations and of exerted forces.
constexpr double kMemory = 0.02;

// Rises from 0 to 1 over s in [0, 1], with vanishing slope at both ends.
double cycloid_part(double s) {
  s = std::clamp(s, 0.0, 1.0);
  return s - sine(2 * std::numbers::pi * s) / (2 * std::numbers::pi);
}

// 1 during [0, duration], with smooth flanks of a tenth of the duration.
double thrust_profile(double elapsed, double duration) {
  const double flank = 0.1 * duration;
  return cycloid_part(elapsed / flank) * cycloid_part((duration - elapsed) / flank);
}

// Slope 1 at s = 0. Value, and all else up to the second derivative, vanish at s = 0 and 1.
double fading_slope(double s) { return s >= 1 ? 0 : s * (1 + s * s * (-6 + s * (8 - s * 3))); }

void visit_vector(const std::function<void(double&)>& visit, Eigen::Vector3d& vector) {
  for (double& component : vector) visit(component);
}

}  // namespace

// Velocities belong to half a step before the time. `since` is one step before it, so that the first prescribed step
// continues the last one.
void SpacecraftDrive::Guide::turn_on(double since, const Eigen::Vector3d& rate_then,
                                     const Eigen::Vector3d& acceleration_then) {
  if (is_on()) return;
  begin = since;
  rate = rate_then;
  acceleration = acceleration_then;
}

double SpacecraftDrive::Guide::at(int axis, double time, double wanted, double progress) const {
  const double swing = acceleration[axis] * kChangeDuration * fading_slope((time - begin) / kChangeDuration);
  return rate[axis] + (wanted - rate[axis]) * progress + swing;
}

SpacecraftDrive::SpacecraftDrive(const TowingParameters& towing, StationKeeping station_keeping, double total_mass,
                                 std::int32_t spacecraft, std::shared_ptr<const CaptureTimes> times)
    : given_(towing),
      towing_(towing),
      station_keeping_(station_keeping),
      total_mass_(total_mass),
      spacecraft_(spacecraft),
      times_(std::move(times)) {
  towing_ = with_times(towing_, 0);
}

void SpacecraftDrive::follow(const Orbit& orbit) {
  orbit_.emplace(orbit);
  first_axes_ = orbit_->local_axes(0);
}

// The towing as the events of the capture have it at the time `now` (s).
TowingParameters SpacecraftDrive::with_times(TowingParameters towing, double now) const {
  if (!times_) return towing;
  towing.start = times_->towing_start;
  if (now >= times_->towing_end) towing.mode = TowingMode::none;
  return towing;
}

void SpacecraftDrive::follow_times(double now) {
  if (!times_) return;
  // A start that lies ahead changes nothing that acts. An end does.
  if (now >= times_->towing_end && towing_.mode != TowingMode::none) {
    change(with_times(given_, now), station_keeping_, now);
  }
  towing_.start = times_->towing_start;
}

void SpacecraftDrive::update(const Measurements& measurements, double /*interval*/, Commands& commands) {
  follow_times(measurements.time());
  commands.body(spacecraft_) = at(measurements.time(), measurements.motion(spacecraft_));
}

void SpacecraftDrive::after_step(const Measurements& measurements, double dt) {
  note_step(measurements.exerted(spacecraft_), measurements.motion(spacecraft_), dt);
}

void SpacecraftDrive::change(const Scenario& scenario, double now) {
  given_ = scenario.towing;
  change(with_times(given_, now), scenario.spacecraft.station_keeping, now);
}

// Present force and torque. Where the motion is prescribed: the mean.
Wrench SpacecraftDrive::acting() const {
  Wrench wrench = exerted_;
  if (tow_.is_on()) wrench.force.y() = mean_exerted_.force.y();
  if (lateral_.is_on()) {
    wrench.force.x() = mean_exerted_.force.x();
    wrench.force.z() = mean_exerted_.force.z();
  }
  if (attitude_.is_on()) wrench.torque = mean_exerted_.torque;
  return wrench;
}

void SpacecraftDrive::change(const TowingParameters& towing, StationKeeping station_keeping, double now) {
  const bool tow_changes = !(towing == towing_), holds_change = station_keeping != station_keeping_;
  if (!tow_changes && !holds_change) return;
  released_ = acting();
  changed_ = now;
  if (tow_changes) tow_ = {};
  if (holds_change) {
    if (station_keeping != StationKeeping::lateral) lateral_ = {};
    if (station_keeping == StationKeeping::free) attitude_ = {};
  }
  towing_ = towing;
  station_keeping_ = station_keeping;
}

void SpacecraftDrive::hold(double time, const RigidMotion& craft, BodyControl& control) {
  control.hold_attitude = station_keeping_ != StationKeeping::free;
  if (control.hold_attitude) {
    attitude_.turn_on(time - last_step_, craft.angular_velocity, mean_angular_acceleration_);
    const double progress = part_changed(attitude_.begin, time);
    const Eigen::Vector3d wanted = orbit_ ? orbit_->turning(time) : Eigen::Vector3d::Zero();
    for (int axis = 0; axis < 3; ++axis) control.spin[axis] = attitude_.at(axis, time, wanted[axis], progress);
  }
  if (station_keeping_ != StationKeeping::lateral) return;
  lateral_.turn_on(time - last_step_, craft.velocity, mean_acceleration_);
  const double progress = part_changed(lateral_.begin, time);
  for (const int axis : {0, 2}) control.velocity[axis] = lateral_.at(axis, time, 0, progress);
}

double SpacecraftDrive::thrust(double elapsed) const {
  const double unit = towing_.mode == TowingMode::acceleration ? total_mass_ : 1;
  return -towing_.size * unit * thrust_profile(elapsed, towing_.duration);
}

void SpacecraftDrive::tow(double time, const RigidMotion& craft, BodyControl& control) {
  if (!pulls(time)) return;
  if (towing_.mode == TowingMode::velocity) {
    tow_.turn_on(time - last_step_, craft.velocity, mean_acceleration_);
    const double progress = cycloid_part((time - tow_.begin) / towing_.duration);
    control.velocity[1] = tow_.at(1, time, -towing_.size, progress);
    return;
  }
  control.force.y() = part_changed(changed_, time) * thrust(time - towing_.start);
  if (orbit_) control.force = orbit_->local_axes(time) * (first_axes_.transpose() * control.force);
  control.point.x() = towing_.offset * cosine(towing_.offset_angle);
  control.point.z() = towing_.offset * sine(towing_.offset_angle);
}

BodyControl SpacecraftDrive::at(double time, const RigidMotion& craft) {
  BodyControl control;
  hold(time, craft, control);
  tow(time, craft, control);
  const double left = 1 - part_changed(changed_, time);
  control.at_centre = {left * released_.force, left * released_.torque};
  before_ = craft;
  return control;
}

void SpacecraftDrive::note_step(const Wrench& exerted, const RigidMotion& craft, double dt) {
  const double part = std::min(1.0, dt / kMemory);
  const auto follow = [&](Eigen::Vector3d& mean, const Eigen::Vector3d& value) { mean += part * (value - mean); };
  exerted_ = exerted;
  last_step_ = dt;
  follow(mean_exerted_.force, exerted.force);
  follow(mean_exerted_.torque, exerted.torque);
  follow(mean_acceleration_, (craft.velocity - before_.velocity) / dt);
  follow(mean_angular_acceleration_, (craft.angular_velocity - before_.angular_velocity) / dt);
}

void SpacecraftDrive::visit_state(const std::function<void(double&)>& visit) {
  visit(changed_);
  visit(last_step_);
  for (Wrench* wrench : {&released_, &exerted_, &mean_exerted_}) {
    visit_vector(visit, wrench->force);
    visit_vector(visit, wrench->torque);
  }
  for (Guide* guide : {&tow_, &lateral_, &attitude_}) {
    visit(guide->begin);
    visit_vector(visit, guide->rate);
    visit_vector(visit, guide->acceleration);
  }
  visit_vector(visit, mean_acceleration_);
  visit_vector(visit, mean_angular_acceleration_);
  // An end of the towing is a change, so the last change tells whether it has been adopted.
  if (times_) towing_ = with_times(given_, changed_);
}

}  // namespace netpocket
