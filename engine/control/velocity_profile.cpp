#include "engine/control/velocity_profile.h"

#include <algorithm>
#include <numbers>

#include "engine/math/elementary.h"

namespace netpocket {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

double part_of_profile(const VelocityProfile& profile, double time) {
  return std::clamp((time - profile.start) / profile.duration, 0.0, 1.0);
}

}  // namespace

double VelocityProfile::velocity(double time) const {
  const double s = part_of_profile(*this, time);
  if (s == 1) return to;
  return from + (to - from) * (s - sine(kTurn * s) / kTurn);
}

double VelocityProfile::acceleration(double time) const {
  const double s = part_of_profile(*this, time);
  if (s == 0 || s == 1) return 0;
  return (to - from) / duration * (1 - cosine(kTurn * s));
}

}  // namespace netpocket
