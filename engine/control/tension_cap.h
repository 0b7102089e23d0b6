#pragma once
// Keeps the tension of a tow line below a cap by taking from the demanded thrust.
//
// With the tension T and its cap C the relief R takes from the demand D:
//   thrust = D - R - P max(0, T - C),  R' = I (T - C),  0 <= R <= D.
// R grows while the tension exceeds the cap and is given back below it. A line with a tension of q times the thrust
// ends at the cap; without P the excess decays as exp(-q I t). It is a kind of override control (Astrom & Hagglund,
// Advanced PID Control (2006)): the integrator acts only while the tension is too large.

#include "engine/control/visited_numbers.h"

namespace netpocket {

struct TensionCapSettings {
  double cap = 0;           // C, N
  double proportional = 0;  // P, dimensionless
  double integral = 1;      // I, 1/s
};

class TensionCap {
 public:
  explicit TensionCap(const TensionCapSettings& settings) : settings_(settings) {}

  // Thrust (N) for the demanded one after another period `dt` (s), between 0 and the demand. A demand to push
  // (negative) passes.
  double update(double demand, double tension, double dt);

  double relief() const { return relief_; }  // R, N
  void visit_state(const NumberVisitor& visit) { visit(relief_); }

 private:
  TensionCapSettings settings_;
  double relief_ = 0;
};

}  // namespace netpocket
