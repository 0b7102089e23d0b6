#include "engine/dynamics/towing.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/math/elementary.h"

namespace netpocket {
namespace {

// From 0 to 1 over s in [0, 1], with vanishing slope at both ends.
double cycloid(double s) {
  s = std::clamp(s, 0.0, 1.0);
  return s - sine(2 * std::numbers::pi * s) / (2 * std::numbers::pi);
}

// 1 during [0, duration], with smooth flanks a tenth of the duration long.
double thrust_profile(double elapsed, double duration) {
  const double flank = 0.1 * duration;
  return cycloid(elapsed / flank) * cycloid((duration - elapsed) / flank);
}

}  // namespace

SpacecraftDrive::SpacecraftDrive(const TowingParameters& towing, StationKeeping station_keeping, double total_mass)
    : towing_(towing), station_keeping_(station_keeping), total_mass_(total_mass) {}

void SpacecraftDrive::change(const TowingParameters& towing, StationKeeping station_keeping) {
  towing_ = towing;
  station_keeping_ = station_keeping;
}

BodyControl SpacecraftDrive::at(double time, double velocity_y) {
  BodyControl control;
  control.hold_attitude = station_keeping_ != StationKeeping::free;
  if (station_keeping_ == StationKeeping::lateral) control.velocity[0] = control.velocity[2] = 0.0;
  const double elapsed = time - towing_.start;
  if (towing_.mode == TowingMode::none) return control;
  if (elapsed < 0) {
    velocity_at_start_ = velocity_y;
    return control;
  }
  switch (towing_.mode) {
    case TowingMode::velocity:
      control.velocity[1] =
          velocity_at_start_ + (-towing_.size - velocity_at_start_) * cycloid(elapsed / towing_.duration);
      break;
    case TowingMode::force:
      control.force.y() = -towing_.size * thrust_profile(elapsed, towing_.duration);
      break;
    case TowingMode::acceleration:
      control.force.y() = -towing_.size * total_mass_ * thrust_profile(elapsed, towing_.duration);
      break;
    case TowingMode::none:
      break;
  }
  control.point.x() = towing_.offset * cosine(towing_.offset_angle);
  control.point.z() = towing_.offset * sine(towing_.offset_angle);
  return control;
}

}  // namespace netpocket
