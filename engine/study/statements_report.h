#pragma once
// Judges the statements of a study at each of its points and writes them as a document.

#include <string>
#include <vector>

#include "engine/study/study_record.h"

namespace netpocket {

// Markdown: a table of all statements with their verdicts, then each with its values at each point, then the columns of
// report.show. Points that differ in solver.seed only are draws of one point. A statement holds at a point if it holds
// in each of its draws, and is undecided if it holds in some.
std::string statements_report(const Study& study, const std::vector<StudyRecord>& records);

}  // namespace netpocket
