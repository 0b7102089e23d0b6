#pragma once
// Writes what a campaign estimates as a document.

#include <string>

#include "engine/study/run_study.h"
#include "engine/study/study_results.h"

namespace netpocket {

// Markdown: the study's description, the uncertain inputs with quantiles of the values that were used, the probability
// of capture with both intervals, quantiles of what was measured, indices if the study has them, and the captures that
// failed or came nearest to it: those of the least escape_depth. `results`: of the study's folder.
std::string campaign_report(const Study& study, const StudyOutcome& outcome, const StudyResults& results);

}  // namespace netpocket
