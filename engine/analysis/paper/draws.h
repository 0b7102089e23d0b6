#pragma once
// Whether a chaotic quantity falls from case to case, by draws: runs that differ by tiny perturbations at the start.
//
// The quantity is positive and spreads by factors (a peak force), so that its logarithm is compared. The difference of
// two cases' means of log has Welch's interval (B. L. Welch, Biometrika 34 (1947) 28): Student's t with Satterthwaite's
// degrees of freedom. The intervals of all pairs hold together with 95 % (Bonferroni).

#include <string>
#include <vector>

#include "engine/analysis/verdict.h"

namespace netpocket {

// Of one case.
struct Draws {
  double closing_end = 0;  // s
  std::vector<double> values;
};

// A mean of logarithms or a difference of two, as a factor: exp of it.
struct FactorInterval {
  double middle = 0;
  double low = 0;
  double high = 0;
};

// exp of the mean of log, with its 95 % interval. Needs two draws.
FactorInterval geometric_mean(const std::vector<double>& values);
// Of b's geometric mean over a's; holds with the probability `confidence`. Needs two draws of each.
FactorInterval ratio_of_means(const std::vector<double>& a, const std::vector<double>& b, double confidence);

// What is said where a case has a single draw.
inline constexpr const char* kOneDraw = "one draw decides nothing";

struct OrderOfDraws {
  Verdict verdict = Verdict::undecided;
  std::string text;  // the means, spreads and ratios behind it, or why nothing is decided
};

// Whether the quantity falls with the time in which the closing ends: yes when the intervals of all pairs lie on that
// side, no when one lies on the other side, else undecided; also undecided where a case has a single draw.
// `groups` by rising closing_end, at least two; `unit` of the values.
OrderOfDraws order_of_draws(const std::vector<Draws>& groups, const std::string& unit);

}  // namespace netpocket
