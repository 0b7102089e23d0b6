#pragma once
// Weakens a hinge where a gradient that it joins is short.

namespace netpocket {

// Factor on a hinge's energy for a gradient of this length: 1 from kFirmHold on, falling smoothly to 0 at length 0.
struct HingeHold {
  double hold;  // in [0, 1]
  double rate;  // derivative of hold with respect to length
};
inline constexpr double kFirmHold = 0.5;
inline HingeHold hinge_hold(double length) {
  const double x = length < kFirmHold ? length / kFirmHold : 1.0;
  return {x * x * (3 - 2 * x), 6 / kFirmHold * x * (1 - x)};
}

}  // namespace netpocket
