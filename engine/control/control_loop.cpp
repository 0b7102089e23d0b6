#include "engine/control/control_loop.h"

#include <algorithm>
#include <cmath>

namespace netpocket {
namespace {

// Times are sums of steps. A sample is due this fraction of its period early.
constexpr double kRounding = 1e-9;

Commands commands_for(const CableSystem& system) { return {system.model().bodies.size(), system.model().rope_count()}; }

// Shortest length (m) of a rope within `interval` (s) if it keeps its acceleration. Its length is a parabola in time.
double extrapolated(const RopeMotion& motion, double interval) {
  const auto at = [&](double t) { return motion.length + t * (motion.rate + 0.5 * t * motion.acceleration); };
  double shortest = std::min(motion.length, at(interval));
  const double vertex = -motion.rate / motion.acceleration;
  if (vertex > 0 && vertex < interval) shortest = std::min(shortest, at(vertex));
  // The rope is never taken to be shorter than half of what it is: the step choice watches it.
  return std::max(shortest, 0.5 * motion.length);
}

}  // namespace

ControlLoop::ControlLoop(CableSystem& system)
    : system_(&system), total_(commands_for(system)), shortest_(system.model().rope_count()) {}

void ControlLoop::add(std::unique_ptr<Controller> controller, double period) {
  entries_.push_back({std::move(controller), period, commands_for(*system_), system_->time()});
}

void ControlLoop::before_step(double dt) {
  const Measurements measurements(*system_);
  const double now = system_->time();
  total_.clear();
  for (Entry& entry : entries_) {
    if (entry.period == 0) {
      entry.commands.clear();
      entry.controller->update(measurements, dt, entry.commands);
    } else if (now >= entry.next_sample - kRounding * entry.period) {
      entry.commands.clear();
      entry.controller->update(measurements, entry.period, entry.commands);
      entry.next_sample = entry.period * (std::floor(now / entry.period + kRounding) + 1);
    }
    total_.take(entry.commands, measurements);
  }
  total_.apply(*system_);
}

void ControlLoop::after_step(double dt) {
  const Measurements measurements(*system_);
  for (Entry& entry : entries_) entry.controller->after_step(measurements, dt);
}

void ControlLoop::change(const Scenario& scenario) {
  for (Entry& entry : entries_) entry.controller->change(scenario, system_->time());
}

const std::vector<double>& ControlLoop::shortest_lengths(double until) {
  const double now = system_->time();
  for (std::size_t rope = 0; rope < shortest_.size(); ++rope) {
    const auto index = static_cast<std::int32_t>(rope);
    double shortest = std::numeric_limits<double>::infinity();
    for (const Entry& entry : entries_) {
      shortest = std::min(shortest, entry.controller->shortest_length(index, now, until));
    }
    shortest_[rope] = std::isfinite(shortest) ? shortest : extrapolated(system_->rope_motion(index), until - now);
  }
  return shortest_;
}

std::string ControlLoop::suspicion() const {
  for (const Entry& entry : entries_) {
    if (std::string text = entry.controller->suspicion(); !text.empty()) return text;
  }
  return {};
}

void ControlLoop::visit_state(const std::function<void(double&)>& visit) {
  for (Entry& entry : entries_) {
    entry.controller->visit_state(visit);
    if (entry.period == 0) continue;  // asked again before the next step
    entry.commands.visit_state(visit);
    visit(entry.next_sample);
  }
}

}  // namespace netpocket
