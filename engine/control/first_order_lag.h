#pragma once
// First-order lag x' = (input - x)/T, exact for an input that is constant over a step. A step is given by the mean of x
// over it, so that the integral of x is exact as well.

#include <limits>

#include "engine/control/exponential_decay.h"

namespace netpocket {

class FirstOrderLag {
 public:
  explicit FirstOrderLag(double time_constant)  // T, s; 0: no lag
      : time_constant_(time_constant),
        decay_(time_constant > 0 ? 1 / time_constant : std::numeric_limits<double>::infinity()) {}

  // Steps `x` over `dt` (s) and returns its mean over the step.
  double step(double& x, double input, double dt) {
    const double left = decay_.over(dt);
    const double gap = x - input;
    x = input + gap * left;
    return input + gap * (1 - left) * time_constant_ / dt;
  }

 private:
  double time_constant_;
  ExponentialDecay decay_;
};

}  // namespace netpocket
