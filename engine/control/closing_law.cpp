#include "engine/control/closing_law.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/math/elementary.h"

namespace netpocket {
namespace {

constexpr double kRampFraction = 0.25;  // of the duration, for each ramp of the trapezoid

// Fraction of the way done, 0 to 1, for s = 0 to 1, with its derivatives with respect to s.
struct Progress {
  double value;
  double slope;
  double curvature;
};

Progress cycloid(double s) {
  constexpr double kTurn = 2 * std::numbers::pi;
  return {s - sine(kTurn * s) / kTurn, 1 - cosine(kTurn * s), kTurn * sine(kTurn * s)};
}

Progress quintic(double s) {
  return {s * s * s * (10 + s * (-15 + s * 6)), 30 * s * s * (1 - s) * (1 - s), 60 * s * (1 - s) * (1 - 2 * s)};
}

Progress trapezoid(double s) {
  constexpr double kTop = 1 / (1 - kRampFraction);
  constexpr double kSteepness = kTop / kRampFraction;
  if (s < kRampFraction) return {kSteepness * s * s / 2, kSteepness * s, kSteepness};
  if (s <= 1 - kRampFraction) return {kTop * (s - kRampFraction / 2), kTop, 0};
  const double rest = 1 - s;
  return {1 - kSteepness * rest * rest / 2, kSteepness * rest, -kSteepness};
}

Progress progress(ClosingLaw law, double s) {
  switch (law) {
    case ClosingLaw::cycloid:
      return cycloid(s);
    case ClosingLaw::quintic:
      return quintic(s);
    case ClosingLaw::trapezoid:
      return trapezoid(s);
    case ClosingLaw::linear:
    case ClosingLaw::table:  // computed by between_points
      break;
  }
  return {s, 1, 0};
}

// Largest slope of the progress. All laws but the table have it at s = 0.5.
double largest_slope(ClosingLaw law) { return progress(law, 0.5).slope; }

// Slope at the middle of three points that keeps the cubic monotone: a weighted harmonic mean, zero at an extremum
// (Fritsch & Butland 1984).
double monotone_slope(const Eigen::Vector2d& before, const Eigen::Vector2d& here, const Eigen::Vector2d& after) {
  const Eigen::Vector2d left = here - before;
  const Eigen::Vector2d right = after - here;
  const double left_slope = left.y() / left.x();
  const double right_slope = right.y() / right.x();
  if (left_slope * right_slope <= 0) return 0;
  const double left_weight = 2 * right.x() + left.x();
  const double right_weight = right.x() + 2 * left.x();
  return (left_weight + right_weight) / (left_weight / left_slope + right_weight / right_slope);
}

}  // namespace

ClosingSchedule::ClosingSchedule(const ClosingParameters& parameters, double open_length)
    : law_(parameters.law),
      start_(parameters.start),
      duration_(parameters.duration),
      open_(open_length),
      closed_(parameters.closed_length),
      shortest_(std::min(open_, closed_)),
      fastest_(std::abs(closed_ - open_) / duration_ * largest_slope(law_)) {
  if (law_ == ClosingLaw::table) read_table(parameters.table);
}

void ClosingSchedule::read_table(const std::vector<Eigen::Vector2d>& table) {
  std::vector<Eigen::Vector2d> rows = table;
  rows.front().y() = open_;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const bool at_end = i == 0 || i + 1 == rows.size();
    points_.push_back({rows[i].x(), rows[i].y(), at_end ? 0 : monotone_slope(rows[i - 1], rows[i], rows[i + 1])});
  }
  duration_ = points_.back().time;
  closed_ = points_.back().length;
  const auto shorter = [](const Point& a, const Point& b) { return a.length < b.length; };
  shortest_ = std::min_element(points_.begin(), points_.end(), shorter)->length;
  fastest_ = fastest_between_points();
}

// Between points the speed is a parabola in time. It is largest at a point or at the vertex.
double ClosingSchedule::fastest_between_points() const {
  double fastest = 0;
  for (std::size_t i = 0; i + 1 < points_.size(); ++i) {
    const Point &a = points_[i], &b = points_[i + 1];
    const double h = b.time - a.time;
    const double c1 = h * a.speed, rise = b.length - a.length;
    const double c2 = 3 * rise - h * (2 * a.speed + b.speed), c3 = h * (a.speed + b.speed) - 2 * rise;
    fastest = std::max({fastest, std::abs(a.speed), std::abs(b.speed)});
    const double vertex = -c2 / (3 * c3);
    if (vertex > 0 && vertex < 1) fastest = std::max(fastest, std::abs(c1 + vertex * (2 * c2 + vertex * 3 * c3)) / h);
  }
  return fastest;
}

ClosingState ClosingSchedule::between_points(double elapsed) const {
  const auto after = std::upper_bound(points_.begin() + 1, points_.end() - 1, elapsed,
                                      [](double time, const Point& point) { return time < point.time; });
  const Point& a = *(after - 1);
  const Point& b = *after;
  const double h = b.time - a.time;
  const double s = (elapsed - a.time) / h;
  // Cubic in s: a.length + s (c1 + s (c2 + s c3)).
  const double rise = b.length - a.length;
  const double c1 = h * a.speed;
  const double c2 = 3 * rise - h * (2 * a.speed + b.speed);
  const double c3 = h * (a.speed + b.speed) - 2 * rise;
  return {a.length + s * (c1 + s * (c2 + s * c3)), (c1 + s * (2 * c2 + s * 3 * c3)) / h,
          (2 * c2 + s * 6 * c3) / (h * h)};
}

ClosingState ClosingSchedule::at(double time) const {
  const double elapsed = time - start_;
  if (elapsed <= 0) return {open_, 0, 0};
  if (elapsed >= duration_) return {closed_, 0, 0};
  if (law_ == ClosingLaw::table) return between_points(elapsed);
  const Progress done = progress(law_, elapsed / duration_);
  const double way = closed_ - open_;
  return {open_ + way * done.value, way * done.slope / duration_, way * done.curvature / (duration_ * duration_)};
}

}  // namespace netpocket
