#pragma once
// Probability of rare failures by subset simulation: Au & Beck (2001), Estimation of small failure probabilities in
// high dimensions by subset simulation, Probab. Eng. Mech. 16(4), doi:10.1016/S0266-8920(01)00019-4. The probability is
// a product of conditional ones, each 0.1, of failures that get less and less rare; the samples of each come from
// Markov chains by the modified Metropolis algorithm. Thread contract: any thread may call it.

#include <cstdint>
#include <vector>

#include "engine/statistics/batch_function.h"
#include "engine/statistics/interval.h"

namespace netpocket {

struct SubsetOptions {
  int samples = 500;     // per level, a multiple of 10, >= 100
  int most_levels = 10;  // a probability below 0.1^most_levels is not resolved
  std::uint64_t seed = 1;
};

// A level: the share of all draws with a limit state of at most `limit`, from the first level on.
struct SubsetLevel {
  double limit = 0;
  double probability = 0;
  double most_variation = 0;  // as SubsetResult::most_variation
};

struct SubsetResult {
  double probability = 0;
  // Coefficient of variation of the estimate, with the correlation within chains by eqs. 28 and 29 of Au & Beck. The
  // first takes the levels as independent, the second as fully correlated. Chains of a level begin at points of the
  // last one, so that the truth lies between. An interval should take the second.
  double variation = 0;
  double most_variation = 0;
  std::vector<SubsetLevel> steps = {};  // by level; the last is the failure, or how far the levels came
  int levels = 0;
  int evaluations = 0;
  bool is_resolved = false;  // otherwise `probability` is an upper estimate: the last level did not reach the failure
};

// `limit_state`: of points of independent standard normal numbers; the system fails where it is <= 0. It must be finite
// or infinite, not NaN.
SubsetResult subset_simulation(const BatchFunction& limit_state, int dimensions, const SubsetOptions& options);

// Interval of the probability: its logarithm is taken as normal, with a squared deviation of ln(1 + most_variation^2).
// An estimate that is not resolved has no lower end.
Interval subset_interval(const SubsetResult& result, double confidence);

}  // namespace netpocket
