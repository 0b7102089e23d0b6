#include "engine/ancf/wrinkling.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/math/elementary.h"

namespace netpocket {
namespace {

constexpr double kPi = std::numbers::pi;
// Largest k for which the formulas are used. They lose their digits as u -> 0. Beyond it the moment stays constant: it
// differs from its limit by less than 1e-3.
constexpr double kLargestRatio = 1e4;

// Solves sin u - u cos u = value for u in (0, pi], by Newton's method inside a bracket.
double taut_angle(double value) {
  double low = 0, high = kPi;
  double u = std::min(cube_root(3 * value), kPi);  // from the leading term, u^3/3
  for (int i = 0; i < 60; ++i) {
    const double error = sine(u) - u * cosine(u) - value;
    (error > 0 ? high : low) = u;
    const double slope = u * sine(u);
    double next = slope > 0 ? u - error / slope : low;
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    if (std::abs(next - u) <= 1e-15 * u) return next;
    u = next;
  }
  return u;
}

InflatedBending wrinkled(double k) {
  const double u = taut_angle(kPi / k);
  const double cos_u = cosine(u), doubled = sine(2 * u);
  InflatedBending result(0);
  result.moment = (2 * u - doubled) * k / (2 * kPi);
  result.energy = 1 + k * k * (u * cos_u * cos_u + u / 2 - 0.75 * doubled) / kPi + 2 * k * cos_u;
  return result;
}

}  // namespace

double wrinkling_moment(double pressure, double radius) { return kPi * pressure * radius * radius * radius / 2; }

InflatedBending::InflatedBending(double k) : moment(k), energy(k * k / 2) {
  if (k <= 1) return;
  const double within = std::min(k, kLargestRatio);
  *this = wrinkled(within);
  energy += moment * (k - within);
}

}  // namespace netpocket
