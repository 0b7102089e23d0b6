#pragma once
// Leads the closing ropes from their present motion to a closing law that is chosen during a run.
//
// Length, speed and acceleration are continuous. A quintic in time leads from their present values to those of the new
// law at a later moment. From then on the law rules. Durations from 0.5 s on are tried, each 10 % longer than the one
// before. The first is taken for which
// - the winding speed never exceeds kFastest times the largest speed of the new law or, if larger, the present speed,
// - the ropes are never longer than the open length,
// - they are shorter than both the present length and the shortest of the new law by no more than they need to stop.
// If there is none, as when ropes that are wound in fast must be paid out, they first come to rest within 0.5 s. If the
// new law asks for exactly the present motion, it rules at once.
// Immutable: safe for any number of threads.

#include <array>

#include "engine/control/closing_law.h"

namespace netpocket {

class ClosingTransition {
 public:
  static constexpr double kFastest = 1.1;

  // `before`: motion of the ropes at the time `now` (s).
  ClosingTransition(const ClosingSchedule& schedule, double now, const ClosingState& before);

  ClosingState at(double time) const;  // time in s, not before `now`
  double end() const { return end_; }  // s, from when on the schedule rules

 private:
  // A quintic in time from one state to another.
  struct Leg {
    double begin, end;             // s
    std::array<double, 6> powers;  // m, coefficients in powers of s = (time - begin)/(end - begin)

    ClosingState at(double time) const;
  };

  static Leg leg(double begin, const ClosingState& from, double end, const ClosingState& to);
  bool is_allowed(const Leg& leg) const;
  bool go_over(double begin, const ClosingState& from);
  void come_to_rest(double now, const ClosingState& from);

  ClosingSchedule schedule_;
  double fastest_ = 0;   // m/s, bound of the speed
  double shortest_ = 0;  // m, bound of the length
  double end_;
  std::array<Leg, 2> legs_{};  // the first one comes to rest; unused ones are empty
};

}  // namespace netpocket
