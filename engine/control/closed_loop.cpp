#include "engine/control/closed_loop.h"

#include <algorithm>

#include "engine/control/gradual_change.h"
#include "engine/control/tracking_error.h"

namespace netpocket {
namespace {

void visit_wrench(const NumberVisitor& visit, Wrench& wrench) {
  visit_numbers(visit, wrench.force);
  visit_numbers(visit, wrench.torque);
}

Wrench scaled(double factor, const Wrench& wrench) { return {factor * wrench.force, factor * wrench.torque}; }

double highest_rate(const std::vector<ControllerParameters>& controllers) {
  return std::ranges::max_element(controllers, {}, &ControllerParameters::rate)->rate;
}

// Gives a law the state of another one of the same kind.
void copy_state(ControlLaw& from, ControlLaw& to) {
  std::vector<double> state;
  from.visit_state([&](double& number) { state.push_back(number); });
  std::size_t next = 0;
  to.visit_state([&](double& number) { number = state.at(next++); });
}

}  // namespace

ClosedLoop::ClosedLoop(const Scenario& scenario, const ControlledCraft& craft,
                       std::shared_ptr<const CaptureTimes> times, std::int32_t spacecraft, std::int32_t target)
    : craft_(craft),
      times_(std::move(times)),
      spacecraft_(spacecraft),
      target_(target),
      sensors_(scenario.sensors),
      contact_(target),
      clock_(highest_rate(scenario.controllers)),
      actuators_(scenario) {
  for (const ControllerParameters& controller : scenario.controllers) {
    entries_.push_back({controller, control_law(controller, craft_), SampleClock(controller.rate)});
  }
}

void ClosedLoop::sample(Entry& entry, const Observed& observed, double now) {
  const bool acted = entry.acts;
  entry.acts = times_->is_in(entry.parameters.phase, now) &&
               (entry.parameters.kind != ControllerKind::tow || times_->is_in(ControlPhase::towing, now));
  const double elapsed = now - entry.last_sample;
  const Wrench exerted = elapsed > 0 ? scaled(1 / elapsed, entry.impulse) : Wrench{};
  entry.last_sample = now;
  entry.impulse = {};
  if (!entry.acts) {
    entry.demand = {};
    entry.jump = {};
    return;
  }
  if (acted) entry.law->note_delivered(observed.craft, exerted);
  const Wrench before = entry.demand;
  entry.demand = entry.law->update(observed, now, entry.clock.period());
  if (!entry.jump_is_known) {
    entry.jump_is_known = true;
    entry.jump = {before.force - entry.demand.force, before.torque - entry.demand.torque};
  }
  if (entry.changed >= 0) entry.demand += scaled(1 - part_changed(entry.changed, now), entry.jump);
}

void ClosedLoop::command(const Observed& observed) {
  demanded_ = {};
  for (const Entry& entry : entries_) demanded_ += entry.demand;
  const BodyState& craft = observed.craft;
  actuators_.command({to_body_axes(craft, demanded_.force), to_body_axes(craft, demanded_.torque)},
                     to_body_axes(craft, craft.angular_velocity), clock_.period());
}

void ClosedLoop::update(const Measurements& measurements, double interval, Commands& commands) {
  const double now = measurements.time();
  const Observed truth{measurements.body(spacecraft_), measurements.body(target_), contact_.force()};
  const Observed observed = sensors_.look(now, truth);
  for (Entry& entry : entries_) {
    if (entry.clock.take(now)) sample(entry, observed, now);
  }
  if (clock_.take(now)) command(observed);
  const Wrench exerted = actuators_.step(to_body_axes(truth.craft, truth.craft.angular_velocity), interval);
  const Wrench in_world{to_world_axes(truth.craft, exerted.force), to_world_axes(truth.craft, exerted.torque)};
  commands.body(spacecraft_).at_centre = in_world;
  const Wrench impulse = scaled(interval, in_world);
  impulse_ += impulse;
  for (Entry& entry : entries_) entry.impulse += impulse;
}

void ClosedLoop::after_step(const Measurements& measurements, double dt) { contact_.after_step(measurements, dt); }

void ClosedLoop::change(const Scenario& scenario, double now) {
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    Entry& entry = entries_[i];
    if (scenario.controllers[i] == entry.parameters) continue;
    std::unique_ptr<ControlLaw> next = control_law(scenario.controllers[i], craft_);
    copy_state(*entry.law, *next);
    next->restart();
    entry.law = std::move(next);
    entry.parameters = scenario.controllers[i];
    entry.changed = now;
    entry.jump_is_known = false;
  }
}

ClosedLoop::Effort ClosedLoop::take_effort(double time) {
  Effort effort{demanded_, {}};
  if (time > effort_time_) effort.exerted = scaled(1 / (time - effort_time_), impulse_);
  effort_time_ = time;
  impulse_ = {};
  return effort;
}

ClosedLoop::View ClosedLoop::view(std::size_t controller, const BodyState& craft, const BodyState& target,
                                  double time) const {
  const Entry& entry = entries_[controller];
  ControlPhase phase = entry.parameters.phase;
  if (phase == ControlPhase::always && entry.parameters.kind == ControllerKind::tow) phase = ControlPhase::towing;
  LoopState state = times_->has_begun(phase, time) ? LoopState::over : LoopState::waiting;
  if (times_->is_in(phase, time)) state = LoopState::active;
  if (phase == ControlPhase::off) state = LoopState::off;
  return {state, entry.law->tracking(craft, target, time), entry.demand};
}

Wrench ClosedLoop::disturbance() const {
  Wrench sum;
  for (const Entry& entry : entries_) sum += entry.law->disturbance();
  return sum;
}

bool ClosedLoop::has_observer() const {
  return std::ranges::any_of(entries_, [](const Entry& entry) { return entry.parameters.observer > 0; });
}

void ClosedLoop::visit_state(const std::function<void(double&)>& visit) {
  sensors_.visit_state(visit);
  contact_.visit_state(visit);
  for (Entry& entry : entries_) {
    entry.law->visit_state(visit);
    entry.clock.visit_state(visit);
    visit_flag(visit, entry.acts);
    visit_flag(visit, entry.jump_is_known);
    visit(entry.last_sample);
    visit(entry.changed);
    for (Wrench* wrench : {&entry.demand, &entry.impulse, &entry.jump}) visit_wrench(visit, *wrench);
  }
  clock_.visit_state(visit);
  actuators_.visit_state(visit);
  visit_wrench(visit, demanded_);
  visit_wrench(visit, impulse_);
  visit(effort_time_);
}

}  // namespace netpocket
