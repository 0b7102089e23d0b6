#pragma once
// How what is changed in the midst of a run goes over from what it was: within half a second, with speed and
// acceleration that vanish at both ends, so that no force jumps.

#include <algorithm>
#include <functional>

namespace netpocket {

inline constexpr double kChangeDuration = 0.5;  // s

// From 0 to 1 over s = 0 to 1 with vanishing first and second derivatives at both ends: exactly 0 and 1 beyond.
inline double smooth_step(double s) {
  const double t = std::clamp(s, 0.0, 1.0);
  return t == 1 ? 1 : t * t * t * (10 + t * (-15 + t * 6));
}

// The part of a change at `begin` (s) that is made at `time` (s).
inline double part_changed(double begin, double time) { return smooth_step((time - begin) / kChangeDuration); }

// A number that goes over to another one.
class GradualChange {
 public:
  explicit GradualChange(double value) : from_(value), to_(value) {}

  // Goes over to `value` from what it is at `now` (s).
  void change(double value, double now) {
    if (value == to_) return;
    from_ = at(now);
    to_ = value;
    begin_ = now;
  }
  double at(double time) const { return is_done(time) ? to_ : from_ + (to_ - from_) * part_changed(begin_, time); }
  bool is_done(double time) const { return time >= begin_ + kChangeDuration; }

  // Gives every number of the state but the one to which it goes over, which is the scenario's, to `visit`.
  void visit_state(const std::function<void(double&)>& visit) {
    visit(from_);
    visit(begin_);
  }

 private:
  double from_, to_;
  double begin_ = -kChangeDuration;  // s: over before the start
};

}  // namespace netpocket
