#pragma once
// How the closing ropes go over from the motion they have to a law of closing that is chosen in the midst of a run.
//
// Length, speed and acceleration go on from what they are. A quintic in time leads from them to those of the new law at
// a later moment, from which on the law rules. That moment is the earliest, in steps of a tenth from half a second on,
// at which
//   - the ropes are at no time wound faster than kFastest times the largest speed of the new law or that they have,
//   - they are never longer than the open length, nor shorter than the shortest of the new law and the present length
//     by more than they need to come to rest.
// Where there is none, as when ropes that run in fast are to be paid out, they first come to rest within half a second.
// A law that asks at the moment of the change for what the ropes do rules at once.
// Immutable: any thread may use it.

#include <array>

#include "engine/control/closing_law.h"

namespace netpocket {

class ClosingTransition {
 public:
  static constexpr double kFastest = 1.1;

  // From `before`, which the ropes do at the time `now` (s).
  ClosingTransition(const ClosingSchedule& schedule, double now, const ClosingState& before);

  ClosingState at(double time) const;  // time in s, from `now` on
  double end() const { return end_; }  // s, from which on the schedule rules

 private:
  // A quintic in time from one state to another.
  struct Leg {
    double begin, end;             // s
    std::array<double, 6> powers;  // of the part of the way, 0 to 1; m

    ClosingState at(double time) const;
  };

  static Leg leg(double begin, const ClosingState& from, double end, const ClosingState& to);
  bool is_allowed(const Leg& leg) const;
  bool go_over(double begin, const ClosingState& from);
  void come_to_rest(double now, const ClosingState& from);

  ClosingSchedule schedule_;
  double fastest_ = 0;   // m/s
  double shortest_ = 0;  // m
  double end_;
  std::array<Leg, 2> legs_{};  // first the one to rest; empty where there is none
};

}  // namespace netpocket
