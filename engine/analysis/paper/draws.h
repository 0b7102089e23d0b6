#pragma once
// Decides whether a chaotic quantity falls from case to case, by draws: runs that differ by tiny initial perturbations.
//
// The quantity (a peak force) is positive and spreads by factors, so its logarithm is compared. The difference of the
// mean logarithms of two cases has Welch's interval (B. L. Welch, Biometrika 34 (1947) 28): Student's t with
// Satterthwaite's degrees of freedom. The intervals of all pairs hold together with 95 % (Bonferroni).

#include <string>
#include <vector>

#include "engine/analysis/verdict.h"

namespace netpocket {

// The draws of one case.
struct Draws {
  double closing_end = 0;  // s
  std::vector<double> values;
};

// exp of a mean of logarithms or of a difference of two such means, with an interval.
struct FactorInterval {
  double middle = 0;
  double low = 0;
  double high = 0;
};

// exp of the mean logarithm, with its 95 % interval. Needs at least two draws.
FactorInterval geometric_mean(const std::vector<double>& values);
// Ratio of the geometric mean of b to that of a. The interval holds with probability `confidence`. Needs at least two
// draws of each.
FactorInterval ratio_of_means(const std::vector<double>& a, const std::vector<double>& b, double confidence);

// Text for a case with a single draw.
inline constexpr const char* kOneDraw = "one draw decides nothing";

struct OrderOfDraws {
  Verdict verdict = Verdict::undecided;
  std::string text;  // the means, intervals and ratios behind the verdict, or why nothing is decided
};

// Whether the quantity falls as the closing ends later. Yes when the intervals of all pairs lie on that side. No when
// one lies on the other side. Undecided otherwise, and when a case has a single draw or a value that is not positive.
// `groups`: sorted by rising closing_end, at least two. `unit`: of the values.
OrderOfDraws order_of_draws(const std::vector<Draws>& groups, const std::string& unit);

}  // namespace netpocket
