#include "engine/orbit/reference_orbit.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "engine/math/elementary.h"
#include "engine/math/power.h"
#include "engine/orbit/gravity.h"

namespace netpocket {
namespace {

using State = ReferenceOrbit::State;

// Error per step of the integration, as a fraction of radius and speed, and the first step as a part of |r|/|v|.
constexpr double kTolerance = 1e-12, kFirstStep = 0.01;
// The polynomial between steps is as exact as the integration up to this part of |r|/|v|.
constexpr double kLongestStep = 0.05;
constexpr double kSmallestFactor = 0.2, kLargestFactor = 2, kSafety = 0.9;

// Columns: V-bar, R-bar, H-bar, in the axes of `state`.
Eigen::Matrix3d local_axes_of(const State& state) {
  const Eigen::Vector3d down = -state.position.normalized();
  const Eigen::Vector3d across = -state.position.cross(state.velocity).normalized();
  Eigen::Matrix3d axes;
  axes << across.cross(down), down, across;
  return axes;
}

Eigen::Vector3d direction(const Eigen::Matrix3d& local, LocalAxis axis) {
  const int index = static_cast<int>(axis);
  return (index % 2 == 0 ? 1.0 : -1.0) * local.col(index / 2);
}

struct Rates {
  Eigen::Vector3d velocity, acceleration;
};

// The coefficients of Dormand & Prince (1980), RK5(4)7M.
constexpr int kStages = 7;
constexpr std::array<std::array<double, 6>, kStages> kNodes = {
    {{},
     {1.0 / 5},
     {3.0 / 40, 9.0 / 40},
     {44.0 / 45, -56.0 / 15, 32.0 / 9},
     {19372.0 / 6561, -25360.0 / 2187, 64448.0 / 6561, -212.0 / 729},
     {9017.0 / 3168, -355.0 / 33, 46732.0 / 5247, 49.0 / 176, -5103.0 / 18656},
     {35.0 / 384, 0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84}}};
// Fifth less fourth order.
constexpr std::array<double, kStages> kError = {71.0 / 57600,      0,          -71.0 / 16695, 71.0 / 1920,
                                                -17253.0 / 339200, 22.0 / 525, -1.0 / 40};

struct Trial {
  State state;
  double error;  // by the tolerance
};

template <typename Acceleration>
Trial try_step(const State& begin, double step, const Acceleration& acceleration) {
  std::array<Rates, kStages> rates;
  State stage = begin;
  for (int i = 0; i < kStages; ++i) {
    stage = begin;
    for (int j = 0; j < i; ++j) {
      stage.position += step * kNodes[i][j] * rates[j].velocity;
      stage.velocity += step * kNodes[i][j] * rates[j].acceleration;
    }
    rates[i] = {stage.velocity, acceleration(stage.position)};
  }
  Eigen::Vector3d position = Eigen::Vector3d::Zero(), velocity = position;
  for (int i = 0; i < kStages; ++i) {
    position += step * kError[i] * rates[i].velocity;
    velocity += step * kError[i] * rates[i].acceleration;
  }
  const double error = std::max(position.norm() / begin.position.norm(), velocity.norm() / begin.velocity.norm());
  return {stage, error / kTolerance};
}

// Position and velocity of the polynomial of degree 5 at the part s of a step from `a` to `b` of `h` seconds.
struct End {
  Eigen::Vector3d position, velocity, acceleration;
};
State between(const End& a, const End& b, double h, double s) {
  const Eigen::Vector3d v0 = h * a.velocity, v1 = h * b.velocity;
  const Eigen::Vector3d a0 = h * h * a.acceleration, a1 = h * h * b.acceleration;
  const Eigen::Vector3d way = b.position - a.position - v0 - 0.5 * a0, gain = v1 - v0 - a0, bend = a1 - a0;
  const Eigen::Vector3d c3 = 10 * way - 4 * gain + 0.5 * bend;
  const Eigen::Vector3d c4 = -15 * way + 7 * gain - bend;
  const Eigen::Vector3d c5 = 6 * way - 3 * gain + 0.5 * bend;
  const double s2 = s * s;
  return {a.position + s * v0 + s2 * (0.5 * a0 + s * (c3 + s * (c4 + s * c5))),
          (v0 + s * (a0 + s * (3 * c3 + s * (4 * c4 + 5 * s * c5)))) / h};
}

}  // namespace

Orbit orbit_of(const OrbitElements& elements, OrbitField field, LocalAxis x, LocalAxis y) {
  const double e = elements.eccentricity, p = elements.perigee_radius * (1 + e);
  const auto in_plane = [&](double along, double across) -> Eigen::Vector3d {
    const double c = cosine(elements.argument_of_perigee), s = sine(elements.argument_of_perigee);
    const double first = c * along - s * across, second = s * along + c * across;
    return {first, second * cosine(elements.inclination), second * sine(elements.inclination)};
  };
  const double c = cosine(elements.true_anomaly), s = sine(elements.true_anomaly);
  const double radius = p / (1 + e * c), speed = std::sqrt(kEarthMu / p);
  return {field, in_plane(radius * c, radius * s), in_plane(-speed * s, speed * (e + c)), x, y};
}

bool are_perpendicular(LocalAxis x, LocalAxis y) { return static_cast<int>(x) / 2 != static_cast<int>(y) / 2; }

ReferenceOrbit::ReferenceOrbit(const Orbit& orbit) : orbit_(orbit) {
  if (!are_perpendicular(orbit.x, orbit.y)) throw std::invalid_argument("two axes of the orbit are parallel");
  const State start{orbit.position, orbit.velocity};
  const Eigen::Matrix3d local = local_axes_of(start);
  const Eigen::Vector3d x = direction(local, orbit.x), y = direction(local, orbit.y);
  axes_ << x, y, x.cross(y);
  j2_ = orbit.field == OrbitField::two_body_j2 ? kEarthJ2 : 0;
  const double radius = orbit.position.norm();
  rate_ = std::sqrt(kEarthMu / (radius * radius * radius));
  ahead_ = radius * local.col(0);
  next_step_ = kFirstStep * radius / orbit.velocity.norm();
  knots_.push_back({0, start, acceleration_at(start.position)});
}

Eigen::Vector3d ReferenceOrbit::acceleration_at(const Eigen::Vector3d& position) const {
  return gravity_at(position, j2_);
}

State ReferenceOrbit::on_circle(double time) const {
  const double c = cosine(rate_ * time), s = sine(rate_ * time);
  return {c * orbit_.position + s * ahead_, rate_ * (c * ahead_ - s * orbit_.position)};
}

void ReferenceOrbit::extend(double time) {
  while (knots_.back().time < time) {
    const Knot& last = knots_.back();
    const double longest = kLongestStep * last.state.position.norm() / last.state.velocity.norm();
    const double step = std::min(next_step_, longest);
    const Trial trial = try_step(last.state, step, [&](const Eigen::Vector3d& r) { return acceleration_at(r); });
    const double factor = kSafety / fifth_root(std::max(trial.error, 1e-10));
    next_step_ = step * std::clamp(factor, kSmallestFactor, kLargestFactor);
    if (trial.error > 1) continue;
    knots_.push_back({last.time + step, trial.state, acceleration_at(trial.state.position)});
  }
}

State ReferenceOrbit::at(double time) {
  if (orbit_.field == OrbitField::hill) return on_circle(time);
  extend(time);
  if (time < knots_[last_knot_].time) last_knot_ = 0;
  while (last_knot_ + 1 < knots_.size() && knots_[last_knot_ + 1].time < time) ++last_knot_;
  const Knot& a = knots_[last_knot_];
  if (time == a.time) return a.state;
  const Knot& b = knots_[last_knot_ + 1];
  const double h = b.time - a.time;
  return between({a.state.position, a.state.velocity, a.acceleration},
                 {b.state.position, b.state.velocity, b.acceleration}, h, (time - a.time) / h);
}

Eigen::Matrix3d ReferenceOrbit::tide(double time) {
  return axes_.transpose() * gravity_gradient_at(at(time).position, j2_) * axes_;
}

Eigen::Matrix3d ReferenceOrbit::local_axes(double time) { return axes_.transpose() * local_axes_of(at(time)); }

// The plane of an orbit about an oblate Earth turns about the radius.
Eigen::Vector3d ReferenceOrbit::turning(double time) {
  const State state = at(time);
  const Eigen::Vector3d momentum = state.position.cross(state.velocity), normal = momentum.normalized();
  const double radius = state.position.norm(), across = acceleration_at(state.position).dot(normal);
  const Eigen::Vector3d rate = momentum / (radius * radius) + across / momentum.norm() * state.position;
  return axes_.transpose() * rate;
}

}  // namespace netpocket
