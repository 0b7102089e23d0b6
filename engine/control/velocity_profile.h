#pragma once
// A wanted velocity that goes smoothly from one value to another.
//
// With s = (t - start)/duration in [0, 1]: v = from + (to - from) (s - sin(2 pi s)/(2 pi)), a cycloid. Acceleration and
// jerk vanish at both ends; the acceleration is largest in the middle, 2 (to - from)/duration.

namespace netpocket {

struct VelocityProfile {
  double start = 0;     // s
  double duration = 1;  // s, positive
  double from = 0;      // m/s
  double to = 0;        // m/s

  double velocity(double time) const;      // m/s
  double acceleration(double time) const;  // m/s^2, its exact derivative
};

}  // namespace netpocket
