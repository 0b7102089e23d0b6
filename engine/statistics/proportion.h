#pragma once
// Confidence intervals of a proportion, such as the probability of capture, from `successes` in `trials` independent
// trials. 0 <= successes <= trials, trials >= 1, 0 < confidence < 1. Pure functions: any thread may call them.

#include <cstdint>

#include "engine/statistics/interval.h"

namespace netpocket {

// Clopper & Pearson (1934), Biometrika 26(4), doi:10.1093/biomet/26.4.404: covers the true proportion with at least the
// confidence, whatever the proportion is. Wider than needed on average.
Interval clopper_pearson_interval(std::int64_t successes, std::int64_t trials, double confidence);

// Wilson (1927), J. Am. Stat. Assoc. 22, doi:10.1080/01621459.1927.10502953, without correction for continuity: covers
// it with the confidence on average over proportions.
Interval wilson_interval(std::int64_t successes, std::int64_t trials, double confidence);

// Rule for ending a campaign early: whether enough trials are done for an interval no wider than asked for. An interval
// that is looked at repeatedly until it is narrow covers slightly less than its confidence. The rule therefore takes
// the Clopper-Pearson interval, which has some in reserve, and asks for kFewestTrials.
inline constexpr std::int64_t kFewestTrials = 30;
bool is_narrow_enough(std::int64_t successes, std::int64_t trials, double confidence, double half_width);

// The number of trials at which the rule ends at the latest, that of a proportion of 1/2. For planning.
std::int64_t most_trials_needed(double confidence, double half_width);

}  // namespace netpocket
