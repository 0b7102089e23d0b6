#pragma once
// Probability of rare failures by subset simulation: Au & Beck (2001), Estimation of small failure probabilities in
// high dimensions by subset simulation, Probab. Eng. Mech. 16(4), doi:10.1016/S0266-8920(01)00019-4. The probability is
// a product of conditional ones, each 0.1, of failures that get less and less rare; the samples of each come from
// Markov chains by the modified Metropolis algorithm. Thread contract: any thread may call it.

#include <cstdint>

#include "engine/statistics/batch_function.h"

namespace netpocket {

struct SubsetOptions {
  int samples = 500;     // per level, a multiple of 10, >= 100
  int most_levels = 10;  // a probability below 0.1^most_levels is not resolved
  std::uint64_t seed = 1;
};

struct SubsetResult {
  double probability = 0;
  // Coefficient of variation of the estimate, by eqs. 28 and 29 of Au & Beck, which take the levels as independent.
  // That makes it too small: for Phi(-3.5) from 500 samples it says 0.38, and 120 estimates vary by 0.57.
  double variation = 0;
  int levels = 0;
  int evaluations = 0;
  bool is_resolved = false;  // otherwise `probability` is an upper estimate: the last level did not reach the failure
};

// `limit_state`: of points of independent standard normal numbers; the system fails where it is <= 0. It must be finite
// or infinite, not NaN.
SubsetResult subset_simulation(const BatchFunction& limit_state, int dimensions, const SubsetOptions& options);

}  // namespace netpocket
