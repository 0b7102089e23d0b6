#include "engine/systems/thrown_net/thrown_net_control.h"

#include <cmath>
#include <limits>
#include <utility>

#include "engine/math/symmetric_algebra.h"

namespace netpocket {
namespace {

constexpr double kNotYet = std::numeric_limits<double>::infinity();

// The scenario as the laws of closing ropes read it.
Scenario with_drawstring(Scenario scenario) {
  scenario.closing = thrown_net_parameters(scenario).drawstring;
  return scenario;
}

}  // namespace

ThrownNetEvents::ThrownNetEvents(const Scenario& scenario, std::int32_t target)
    : given_(thrown_net_parameters(scenario)),
      towing_(scenario.towing),
      target_(target),
      contact_(target),
      times_(std::make_shared<CaptureTimes>()) {
  adopt_given_times();
}

// The times that the scenario gives. Those of events that have happened stay.
void ThrownNetEvents::adopt_given_times() {
  if (given_.draws_at == DrawstringStart::time) times_->closing_start = given_.drawstring.start;
  times_->closing_end = times_->closing_start + given_.drawstring.duration;
  const double start = towing_.starts_at == TowingStart::time ? towing_.start : times_->closing_end;
  times_->towing_start = towing_.mode != TowingMode::none ? start : kNotYet;
}

std::string ThrownNetEvents::awaited() const {
  if (given_.draws_at != DrawstringStart::contact || !std::isinf(times_->closing_start)) return "";
  const bool tow_waits = towing_.mode != TowingMode::none && towing_.starts_at == TowingStart::closed;
  return std::string("the closing never started, since nothing touched the target") +
         (tow_waits ? "; nor did the towing" : "");
}

void ThrownNetEvents::update(const Measurements& measurements, double /*interval*/, Commands& /*commands*/) {
  const double now = measurements.time();
  const bool waits = given_.draws_at == DrawstringStart::contact && std::isinf(times_->closing_start);
  if (waits && !measurements.contact_impulse(target_).isZero(0)) {
    times_->closing_start = now + given_.draw_delay;
    adopt_given_times();
  }
  const bool tows = now >= times_->towing_start && now < times_->towing_end;
  if (tows && towing_.abort_force > 0 && symmetric_norm(contact_.force()) > towing_.abort_force) {
    times_->towing_end = now;
  }
}

void ThrownNetEvents::after_step(const Measurements& measurements, double dt) { contact_.after_step(measurements, dt); }

void ThrownNetEvents::change(const Scenario& scenario, double /*now*/) {
  // A towing that was aborted goes on if the user asks for another one.
  if (!(scenario.towing == towing_)) times_->towing_end = kNotYet;
  given_ = thrown_net_parameters(scenario);
  towing_ = scenario.towing;
  adopt_given_times();
}

void ThrownNetEvents::visit_state(const std::function<void(double&)>& visit) {
  times_->visit_state(visit);
  contact_.visit_state(visit);
}

DrawstringControl::DrawstringControl(const Scenario& scenario, const std::vector<double>& open_lengths,
                                     std::shared_ptr<const CaptureTimes> times) {
  if (scenario.winch.drive == WinchDrive::prescribed) {
    law_ = std::make_unique<ClosingControl>(thrown_net_parameters(scenario).drawstring, open_lengths, std::move(times));
    return;
  }
  auto winches = std::make_unique<WinchControl>(with_drawstring(scenario), open_lengths, std::move(times));
  winches_ = winches.get();
  law_ = std::move(winches);
}

void DrawstringControl::update(const Measurements& measurements, double interval, Commands& commands) {
  law_->update(measurements, interval, commands);
}

void DrawstringControl::change(const Scenario& scenario, double now) { law_->change(with_drawstring(scenario), now); }

double DrawstringControl::shortest_length(std::int32_t rope, double now, double until) const {
  return law_->shortest_length(rope, now, until);
}

}  // namespace netpocket
