#include "engine/control/disturbances.h"

#include <algorithm>

#include "engine/control/tracking_error.h"
#include "engine/control/visited_numbers.h"

namespace netpocket {
namespace {

// Part of the step from `now` over `interval` (s) that the disturbance covers.
double covered_part(const DisturbanceParameters& disturbance, double now, double interval) {
  const double begin = std::max(now, disturbance.start);
  const double end = std::min(now + interval, disturbance.start + disturbance.duration);
  return std::max(0.0, end - begin) / interval;
}

}  // namespace

void Disturbances::update(const Measurements& measurements, double interval, Commands& commands) {
  for (const DisturbanceParameters& disturbance : list_) {
    const double part = covered_part(disturbance, measurements.time(), interval);
    if (part == 0) continue;
    Disturbed& disturbed = bodies_[static_cast<std::size_t>(disturbance.body)];
    const BodyState state = measurements.body(disturbed.body);
    const Wrench wrench = {part * to_world_axes(state, disturbance.force),
                           part * to_world_axes(state, disturbance.torque)};
    commands.body(disturbed.body).at_centre += wrench;
    disturbed.impulse += {interval * wrench.force, interval * wrench.torque};
  }
}

void Disturbances::change(const Scenario& scenario, double /*now*/) { list_ = scenario.disturbances; }

Wrench Disturbances::take_mean(DisturbedBody body, double time) {
  Disturbed& disturbed = bodies_[static_cast<std::size_t>(body)];
  Wrench mean;
  const double elapsed = time - disturbed.since;
  if (elapsed > 0) mean = {disturbed.impulse.force / elapsed, disturbed.impulse.torque / elapsed};
  disturbed.impulse = {};
  disturbed.since = time;
  return mean;
}

void Disturbances::visit_state(const std::function<void(double&)>& visit) {
  for (Disturbed& disturbed : bodies_) {
    visit_numbers(visit, disturbed.impulse.force);
    visit_numbers(visit, disturbed.impulse.torque);
    visit(disturbed.since);
  }
}

}  // namespace netpocket
