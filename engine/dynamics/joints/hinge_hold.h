#pragma once
// What is left of a hinge where a gradient that it holds is short.

namespace netpocket {

// How firmly a hinge holds a gradient of this length: as it is from kFirmHold on, not at all where it vanishes.
struct HingeHold {
  double hold;  // in [0, 1]
  double rate;  // its derivative
};
inline constexpr double kFirmHold = 0.5;
inline HingeHold hinge_hold(double length) {
  const double x = length < kFirmHold ? length / kFirmHold : 1.0;
  return {x * x * (3 - 2 * x), 6 / kFirmHold * x * (1 - x)};
}

}  // namespace netpocket
