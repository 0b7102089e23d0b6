#include "engine/python/python_controller.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace netpocket::python {
namespace {

// Times are sums of steps. A call is due this fraction of its period early.
constexpr double kRounding = 1e-9;

void exert(const PythonCommands::Body& wanted, BodyControl& control) {
  control.force += wanted.force;
  control.point = wanted.point;
  control.at_centre.torque += wanted.torque;
}

// The motion at the end of a step of `dt` (s) in which the rate follows the wanted one.
RopeMotion followed(const RopeMotion& now, const PythonCommands::Rope& wanted, double dt) {
  const double change = std::clamp(wanted.rate - now.rate, -wanted.acceleration * dt, wanted.acceleration * dt);
  const double rate = now.rate + change;
  return {now.length + 0.5 * (now.rate + rate) * dt, rate, 0};
}

}  // namespace

void PythonCommands::visit_state(const std::function<void(double&)>& visit) {
  for (Body& body : bodies) {
    for (Eigen::Vector3d* vector : {&body.force, &body.torque, &body.point}) {
      for (double& component : *vector) visit(component);
    }
  }
  for (Rope& rope : ropes) {
    double is_wound = rope.is_wound ? 1 : 0;
    for (double* value : {&is_wound, &rope.rate, &rope.acceleration}) visit(*value);
    rope.is_wound = is_wound != 0;
  }
}

const Measurements& PythonMeasurements::get() const {
  if (measurements_ == nullptr) throw std::runtime_error("measurements are valid only during the call of a controller");
  return *measurements_;
}

// A run may be dropped by any thread.
PythonController::~PythonController() {
  const py::gil_scoped_acquire lock;
  function_ = py::none();
  state_ = py::none();
}

void PythonController::call(const Measurements& measurements, double interval) {
  const py::gil_scoped_acquire lock;
  if (function_.is_none()) return;
  py::object seen = py::cast(PythonMeasurements(measurements));
  py::object commands = py::cast(&held_, py::return_value_policy::copy);
  try {
    function_(seen, interval, commands);
  } catch (...) {
    seen.cast<PythonMeasurements&>().end();
    throw;
  }
  seen.cast<PythonMeasurements&>().end();
  held_ = commands.cast<const PythonCommands&>();
}

void PythonController::update(const Measurements& measurements, double interval, Commands& commands) {
  const double now = measurements.time();
  if (period_ == 0) {
    call(measurements, interval);
  } else if (now >= next_call_ - kRounding * period_) {
    call(measurements, period_);
    next_call_ = period_ * (std::floor(now / period_ + kRounding) + 1);
  }
  for (std::size_t b = 0; b < held_.bodies.size(); ++b) {
    const PythonCommands::Body& body = held_.bodies[b];
    if (body.force.isZero(0) && body.torque.isZero(0)) continue;
    exert(body, commands.body(static_cast<std::int32_t>(b)));
  }
  for (std::size_t r = 0; r < held_.ropes.size(); ++r) {
    if (!held_.ropes[r].is_wound) continue;
    const auto rope = static_cast<std::int32_t>(r);
    commands.wind(rope, followed(measurements.rope(rope), held_.ropes[r], interval));
  }
}

void PythonController::visit_state(const std::function<void(double&)>& visit) {
  visit(next_call_);
  held_.visit_state(visit);
  const py::gil_scoped_acquire lock;
  if (state_.is_none()) return;
  auto numbers = state_.cast<py::array_t<double>>();
  double* values = numbers.mutable_data();
  for (py::ssize_t i = 0; i < numbers.size(); ++i) visit(values[i]);
}

}  // namespace netpocket::python
