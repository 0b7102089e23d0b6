#pragma once
// PID control of one quantity, within limits.
//
// With the error e = present - wanted:  demand = -(P e + I int e dt + D e') + feed_forward.
// A demand beyond a limit is cut. The integral then holds while the error drives it further beyond (conditional
// integration), so that it does not wind up. Source: Astrom & Hagglund, Advanced PID Control (2006), chapter 3.

#include <limits>

#include "engine/control/visited_numbers.h"

namespace netpocket {

// Units: those of the demand per unit of e, of its integral and of its rate.
struct PidSettings {
  double proportional = 0;
  double integral = 0;
  double derivative = 0;
  double least = -std::numeric_limits<double>::infinity();  // of the demand
  double most = std::numeric_limits<double>::infinity();
};

class Pid {
 public:
  explicit Pid(const PidSettings& settings) : settings_(settings) {}

  // Demand for the error and its rate after another period `dt` (s).
  double update(double error, double rate, double dt, double feed_forward = 0);

  void reset() { integral_ = 0; }
  double integral() const { return integral_; }  // the integral's part of the demand
  void visit_state(const NumberVisitor& visit) { visit(integral_); }

 private:
  PidSettings settings_;
  double integral_ = 0;
};

}  // namespace netpocket
