#pragma once
// Changes values gradually when they are changed during a run: within 0.5 s, with speed and acceleration that vanish at
// both ends, so that no force jumps.

#include <algorithm>
#include <functional>

namespace netpocket {

inline constexpr double kChangeDuration = 0.5;  // s

// Rises from 0 to 1 over s = 0 to 1, with vanishing first and second derivatives at both ends. Exactly 0 or 1 outside.
inline double smooth_step(double s) {
  const double t = std::clamp(s, 0.0, 1.0);
  return t == 1 ? 1 : t * t * t * (10 + t * (-15 + t * 6));
}

// Fraction of a change begun at `begin` (s) that is complete at `time` (s).
inline double part_changed(double begin, double time) { return smooth_step((time - begin) / kChangeDuration); }

// A number that changes gradually.
class GradualChange {
 public:
  explicit GradualChange(double value) : from_(value), to_(value) {}

  // Begins a change from the value at `now` (s) to `value`.
  void change(double value, double now) {
    if (value == to_) return;
    from_ = at(now);
    to_ = value;
    begin_ = now;
  }
  double at(double time) const { return is_done(time) ? to_ : from_ + (to_ - from_) * part_changed(begin_, time); }
  bool is_done(double time) const { return time >= begin_ + kChangeDuration; }

  // Gives the numbers of the state to `visit`, which may change them. The target value is not among them: the scenario
  // has it.
  void visit_state(const std::function<void(double&)>& visit) {
    visit(from_);
    visit(begin_);
  }

 private:
  double from_, to_;
  double begin_ = -kChangeDuration;  // s; a change that was over before the start
};

}  // namespace netpocket
