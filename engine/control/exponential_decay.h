#pragma once
// The factor exp(-rate dt) of a decay. It is computed again only when `dt` changes, because it takes microseconds.

#include <cmath>
#include <numbers>

#include "engine/math/power.h"

namespace netpocket {

class ExponentialDecay {
 public:
  explicit ExponentialDecay(double rate) : rate_(rate) {}  // 1/s; infinite: decays at once

  double over(double dt) {  // dt > 0, s
    if (dt != dt_) {
      dt_ = dt;
      factor_ = std::isinf(rate_) ? 0 : power(std::numbers::e, -rate_ * dt);
    }
    return factor_;
  }

 private:
  double rate_;
  // A pure function of dt, so no part of a state.
  double dt_ = 0;
  double factor_ = 1;
};

}  // namespace netpocket
