#include "engine/control/double_loop.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace netpocket {
namespace {

// The inner loop's sliding variable is the error of the angular velocity itself.
SlidingModeGains without_slope(SlidingModeGains gains) {
  gains.slope = 0;
  return gains;
}

}  // namespace

DoubleLoop::DoubleLoop(const DoubleLoopSettings& settings, const Eigen::Matrix3d& inertia)
    : settings_(settings),
      inner_(without_slope(settings.inner), settings.observer_bandwidth),
      inertia_(inertia),
      inverse_inertia_(inertia.inverse()) {}

DoubleLoop::Approach DoubleLoop::approach(double error, double error_rate) const {
  const double layer = settings_.outer_layer;
  const double rate = -settings_.slope * error - settings_.outer_switching * saturation(error, layer);
  if (std::abs(rate) > settings_.fastest) return {std::clamp(rate, -settings_.fastest, settings_.fastest), 0};
  const double switching_slope = std::abs(error) < layer ? settings_.outer_switching / layer : 0;
  return {rate, -(settings_.slope + switching_slope) * error_rate};
}

Wrench DoubleLoop::update(const BodyState& present, const WantedMotion& wanted, double dt) {
  const Eigen::Vector3d spin = to_body_axes(present, present.angular_velocity);
  const Eigen::Vector3d gyroscopic = spin.cross(inertia_ * spin);
  const TrackingError error = rotation_error(present, wanted.state);
  TrackingError inner;
  Eigen::Vector3d acceleration = to_body_axes(present, wanted.angular_acceleration);
  for (int axis = 0; axis < 3; ++axis) {
    const Approach outer = approach(error.error[axis], error.rate[axis]);
    inner.rate[axis] = error.rate[axis] - outer.rate;
    acceleration[axis] += outer.acceleration;
  }
  acceleration += inner_.update(inner, spin, inverse_inertia_ * (acting_ - gyroscopic), dt);
  acting_ = inertia_ * acceleration + gyroscopic;
  return {Eigen::Vector3d::Zero(), to_world_axes(present, acting_)};
}

void DoubleLoop::visit_state(const NumberVisitor& visit) {
  inner_.visit_state(visit);
  visit_numbers(visit, acting_);
}

}  // namespace netpocket
