#pragma once
// The findings of a study as a document.

#include <string>
#include <vector>

#include "engine/study/study_record.h"

namespace netpocket {

// Markdown. The first point is the one that is judged: a table of all findings by variant, then each finding with its
// rule, its values, at how many of the other points it holds too (robustness) and at which not, and the study's remark
// on it. Then the points and what they changed. Needs at least one point that was run.
std::string findings_report(const Study& study, const std::vector<StudyRecord>& records);

// What the report depends on besides the program's results: the scenarios of all points. It stands in the report, so
// that a test notices that a scenario or a default changed since the report was written.
std::string study_identity(const Study& study);

}  // namespace netpocket
