#pragma once
// Which captures of a study to look at. Pure functions: any thread may call them.

#include <cstddef>
#include <string>
#include <vector>

#include "engine/study/study_results.h"

namespace netpocket {

// What makes a capture bad: a small number of a column, such as the escape depth, or a large one, such as a load.
struct CaptureRanking {
  std::string by = "escape_depth";
  bool largest_is_worst = false;
};

// Rows of the results, the worst first; those without a number of the column last, equal ones in their order. Empty
// when there is no such column.
std::vector<std::size_t> worst_captures(const StudyResults& results, const CaptureRanking& ranking, std::size_t count);

// Rows whose number is nearest to the median of those that were captured, the nearest first.
std::vector<std::size_t> typical_captures(const StudyResults& results, const std::string& by, std::size_t count);

}  // namespace netpocket
