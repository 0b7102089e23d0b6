#include "engine/systems/pocket/pocket_events.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "engine/control/closing_law.h"
#include "engine/math/symmetric_algebra.h"
#include "engine/scenario/pocket_outline.h"

namespace netpocket {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

double duration_of(const ClosingParameters& closing, double open_length) {
  const ClosingSchedule schedule(closing, open_length);
  return schedule.end() - schedule.start();
}

}  // namespace

PocketEvents::PocketEvents(const Scenario& scenario, const Pocket& pocket)
    : closing_(scenario.closing),
      towing_(scenario.towing),
      closing_duration_(duration_of(scenario.closing, open_tip_distance(scenario))),
      open_length_(open_tip_distance(scenario)),
      spacecraft_(pocket.spacecraft),
      base_(pocket.base()),
      target_(pocket.target),
      interior_(pocket),
      contact_(pocket.target),
      times_(std::make_shared<CaptureTimes>()) {
  adopt_given_times();
}

void PocketEvents::begin_closing(double start) {
  times_->closing_start = start;
  times_->closing_end = start + closing_duration_;
}

// The times that the scenario gives. Those of events that have happened stay.
void PocketEvents::adopt_given_times() {
  if (closing_.starts_at == ClosingStart::time) {
    begin_closing(closing_.start);
  } else {
    times_->closing_end = times_->closing_start + closing_duration_;
  }
  const bool tows = towing_.mode != TowingMode::none;
  const double start = towing_.starts_at == TowingStart::time ? towing_.start : times_->closing_end;
  times_->towing_start = tows ? start : kNever;
}

std::string PocketEvents::awaited(double time) const {
  const bool tow_waits = towing_.mode != TowingMode::none && towing_.starts_at == TowingStart::closed;
  if (closing_.starts_at != ClosingStart::time && std::isinf(times_->closing_start)) {
    const std::string reason = closing_.starts_at == ClosingStart::distance
                                   ? fmt::format("spacecraft and target came no nearer than {:g} m", closing_.distance)
                                   : "the target was never inside the pocket";
    const std::string since = closing_.start > 0 ? fmt::format(" from {:g} s on", closing_.start) : "";
    return fmt::format("the closing never started, since {}{}{}", reason, since,
                       tow_waits ? "; nor did the towing" : "");
  }
  if (tow_waits && time < times_->towing_start)
    return fmt::format("the towing never started, since the mouth is closed at {:.4g} s only", times_->towing_start);
  return "";
}

bool PocketEvents::closing_begins(const Measurements& measurements) const {
  if (measurements.time() < closing_.start) return false;
  const BodyState craft = measurements.body(spacecraft_), target = measurements.body(target_);
  if (closing_.starts_at == ClosingStart::distance)
    return symmetric_norm(Eigen::Vector3d(target.position - craft.position)) <= closing_.distance;
  return interior_.contains_target(measurements.body(base_), target,
                                   [&](std::int32_t node) { return measurements.node(node); });
}

void PocketEvents::update(const Measurements& measurements, double /*interval*/, Commands& /*commands*/) {
  const double now = measurements.time();
  if (std::isinf(times_->closing_start) && closing_begins(measurements)) {
    begin_closing(now);
    adopt_given_times();
  }
  const bool tows = now >= times_->towing_start && now < times_->towing_end;
  if (tows && towing_.abort_force > 0 && symmetric_norm(contact_.force()) > towing_.abort_force) {
    times_->towing_end = now;
  }
}

void PocketEvents::after_step(const Measurements& measurements, double dt) { contact_.after_step(measurements, dt); }

void PocketEvents::change(const Scenario& scenario, double /*now*/) {
  // A towing that was aborted goes on if the user asks for another one.
  if (!(scenario.towing == towing_)) times_->towing_end = kNever;
  closing_ = scenario.closing;
  towing_ = scenario.towing;
  closing_duration_ = duration_of(closing_, open_length_);
  adopt_given_times();
}

void PocketEvents::visit_state(const std::function<void(double&)>& visit) {
  times_->visit_state(visit);
  contact_.visit_state(visit);
}

}  // namespace netpocket
