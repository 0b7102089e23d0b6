#pragma once
// Writes what a study found among many points, as a section of a document.

#include <string>
#include <vector>

#include "engine/study/study_record.h"

namespace netpocket {

// Markdown. Describes the study, the number of points at which each finding holds in all variants, and the points at
// which most findings hold. The table has Study::report.best points, in the study's order where equal; with 0 it has
// all points in their order. Its columns are the settings that differ between points and the values of the findings in
// Study::report.show.
std::string search_report(const Study& study, const std::vector<StudyRecord>& records);

// The report that the study's file asks for: findings_report() or search_report().
std::string study_report(const Study& study, const std::vector<StudyRecord>& records);

}  // namespace netpocket
