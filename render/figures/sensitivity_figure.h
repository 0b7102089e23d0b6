#pragma once
// What [sensitivity] of a study found. Pure function: any thread may call it.

#include "engine/study/study_results.h"
#include "render/figures/figure.h"

namespace netpocket {

// A tornado: for each input first-order and total Sobol index with their intervals or, of a screening, the mean size of
// the elementary effects and their deviation. The input that decides most comes first. Of several groups of points and
// variants the first is drawn.
Figure sensitivity_figure(const StudyResults& results);

}  // namespace netpocket
