#pragma once
// Captures over two inputs of a campaign, and the probability of capture between them. Pure functions: any thread may
// call them.

#include <vector>

#include "render/figures/study_curves.h"

namespace netpocket {

// Captured and missed ones, in this order: missed ones lie over the captured ones. Those that were not judged are left
// out, and of many captures some (drawn_captures.h).
std::vector<Curve> captures_over(const StudyResults& results, const ResultColumn& x, const ResultColumn& y,
                                 bool has_labels);

// A figure of one panel with them. Its title says when some are left out.
Figure make_capture_map(const StudyResults& results, const ResultColumn& x, const ResultColumn& y);

// Where the probability of capture is 10, 50 and 90 %, the other inputs as they were drawn: Kriging of the captures,
// yes or no, whose estimated noise is what the other inputs do.
struct ProbabilityContours {
  std::vector<Curve> curves;
  // "Contours: Kriging of 300 captures, leave-one-out R² 0.62".
  std::string quality;
};

// Empty with fewer than twenty captures or only one outcome. Takes up to some seconds.
ProbabilityContours probability_contours(const StudyResults& results, const ResultColumn& x, const ResultColumn& y);

}  // namespace netpocket
