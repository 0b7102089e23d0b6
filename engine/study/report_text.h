#pragma once
// What the reports of a study have in common: Markdown tables, and what a point is called and holds.

#include <string>
#include <vector>

#include "engine/study/study_record.h"

namespace netpocket {

// Text as it may stand in a cell of a table.
std::string markdown_cell(const std::string& text);
// A table's first two lines.
std::string markdown_header(const std::vector<std::string>& names);

// Null when there is none: the point was refused.
const StudyRecord* find_finding(const StudyRecord& record, const std::string& id);
bool holds_in_all_cases(const StudyRecord& finding);
// The findings that hold in all cases, by number.
std::vector<std::string> held_findings(const StudyRecord& record);

std::string point_name(const StudyRecord& record);
std::string settings_text(const StudyRecord& record);

}  // namespace netpocket
