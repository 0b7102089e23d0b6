#pragma once
// What a study found among many points, as a section of a document.

#include <string>
#include <vector>

#include "engine/study/study_record.h"

namespace netpocket {

// Markdown: what the study is, at how many points each finding holds in all variants, and a table of the points at
// which most findings hold (Study::report.best of them, the study's own order among equals; 0: all points in their
// order) with the settings that differ between points and, for Study::report.show, what was found.
std::string search_report(const Study& study, const std::vector<StudyRecord>& records);

// The report that the study's file asks for: findings_report() or search_report().
std::string study_report(const Study& study, const std::vector<StudyRecord>& records);

}  // namespace netpocket
