#pragma once
// Writes the findings of a study as a document.

#include <string>
#include <vector>

#include "engine/study/study_record.h"

namespace netpocket {

// Markdown. The first point is the one that is judged. The document begins with a table of all findings by variant.
// Each finding follows with its rule, its values, the number of other points at which it holds (robustness), those at
// which it does not, and the study's remark on it. The points and what they changed come last. Needs at least one point
// that was run.
std::string findings_report(const Study& study, const std::vector<StudyRecord>& records);

// Hash of the scenarios of all points, on which the report depends besides the program. The report contains it, so that
// a test notices when a scenario or a default has changed since the report was written.
std::string study_identity(const Study& study);

}  // namespace netpocket
