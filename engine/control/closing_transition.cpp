#include "engine/control/closing_transition.h"

#include <algorithm>
#include <cmath>

namespace netpocket {
namespace {

constexpr double kBriefest = 0.5;   // s, shortest duration of a leg
constexpr double kGrowth = 1.1;     // ratio of successive durations tried
constexpr int kTrials = 120;        // up to 0.5 s times 1.1^119: half a day
constexpr int kSamplesOfLeg = 128;  // points of a leg at which speed and length are checked
// Winding speed (1/s, per open length) that is always allowed, even if no law asks for any speed.
constexpr double kLeastSpeed = 0.01;

}  // namespace

ClosingTransition::Leg ClosingTransition::leg(double begin, const ClosingState& from, double end,
                                              const ClosingState& to) {
  const double duration = end - begin;
  const double v0 = from.speed * duration, v1 = to.speed * duration;
  const double a0 = from.acceleration * duration * duration, a1 = to.acceleration * duration * duration;
  const double way = to.length - from.length;
  return {begin,
          end,
          {from.length, v0, 0.5 * a0, 10 * way - 6 * v0 - 4 * v1 - 1.5 * a0 + 0.5 * a1,
           -15 * way + 8 * v0 + 7 * v1 + 1.5 * a0 - a1, 6 * way - 3 * (v0 + v1) - 0.5 * (a0 - a1)}};
}

ClosingState ClosingTransition::Leg::at(double time) const {
  const double duration = end - begin, s = (time - begin) / duration;
  const auto& c = powers;
  return {c[0] + s * (c[1] + s * (c[2] + s * (c[3] + s * (c[4] + s * c[5])))),
          (c[1] + s * (2 * c[2] + s * (3 * c[3] + s * (4 * c[4] + s * 5 * c[5])))) / duration,
          (2 * c[2] + s * (6 * c[3] + s * (12 * c[4] + s * 20 * c[5]))) / (duration * duration)};
}

bool ClosingTransition::is_allowed(const Leg& leg) const {
  for (int i = 1; i < kSamplesOfLeg; ++i) {
    const ClosingState state = leg.at(leg.begin + (leg.end - leg.begin) * i / kSamplesOfLeg);
    if (!(std::abs(state.speed) <= fastest_ && state.length >= shortest_ && state.length <= schedule_.open_length()))
      return false;
  }
  return true;
}

bool ClosingTransition::go_over(double begin, const ClosingState& from) {
  double duration = kBriefest;
  for (int trial = 0; trial < kTrials; ++trial, duration *= kGrowth) {
    legs_[1] = leg(begin, from, begin + duration, schedule_.at(begin + duration));
    if (is_allowed(legs_[1])) return true;
  }
  return false;
}

// Comes to rest where a steady deceleration would; sooner where there is no room for that.
void ClosingTransition::come_to_rest(double now, const ClosingState& from) {
  double duration = kBriefest;
  for (int trial = 0; trial < kTrials; ++trial, duration /= kGrowth) {
    const double stop = std::clamp(from.length + 0.5 * from.speed * duration, shortest_, schedule_.open_length());
    legs_[0] = leg(now, from, now + duration, {stop, 0, 0});
    if (is_allowed(legs_[0])) break;
  }
}

ClosingTransition::ClosingTransition(const ClosingSchedule& schedule, double now, const ClosingState& before)
    : schedule_(schedule), end_(now) {
  if (before == schedule.at(now)) return;
  fastest_ = kFastest *
             std::max({std::abs(before.speed), schedule.fastest(), kLeastSpeed * schedule.open_length() / kFastest});
  const double least = std::min(before.length, schedule.shortest());
  shortest_ = std::max(least - 0.5 * kBriefest * std::abs(before.speed), 0.5 * least);
  if (!go_over(now, before)) {
    come_to_rest(now, before);
    const Leg& stopping = legs_[0];
    go_over(stopping.end, stopping.at(stopping.end));
  }
  end_ = legs_[1].end;
}

ClosingState ClosingTransition::at(double time) const {
  if (time >= end_) return schedule_.at(time);
  ClosingState state = legs_[time < legs_[0].end ? 0 : 1].at(time);
  state.length = std::min(state.length, schedule_.open_length());
  return state;
}

}  // namespace netpocket
