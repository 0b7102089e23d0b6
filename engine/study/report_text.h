#pragma once
// Parts that the reports of a study share: Markdown tables, names of points, and lists of findings.

#include <string>
#include <vector>

#include "engine/study/study_record.h"

namespace netpocket {

// Escapes text for a cell of a table.
std::string markdown_cell(const std::string& text);
// The first two lines of a table.
std::string markdown_header(const std::vector<std::string>& names);

// Null when there is no such finding, as in a refused point.
const StudyRecord* find_finding(const StudyRecord& record, const std::string& id);
bool holds_in_all_cases(const StudyRecord& finding);
// Findings that hold in all cases, by number.
std::vector<std::string> held_findings(const StudyRecord& record);

std::string point_name(const StudyRecord& record);
std::string settings_text(const StudyRecord& record);

}  // namespace netpocket
