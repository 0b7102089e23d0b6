#pragma once
// Figures of what a study's search found. Pure functions: any thread may call them.

#include "engine/study/study_results.h"
#include "render/figures/figure.h"

namespace netpocket {

// Objective of each candidate by generation: those that meet the constraints, those that do not, and the best so far.
// Another panel shows by how much the constraints are violated, if any were.
Figure optimisation_figure(const StudyResults& results);

// Probability of each level of a subset simulation over the value at which it fails, with the intervals.
Figure rare_failure_figure(const StudyResults& results);

}  // namespace netpocket
