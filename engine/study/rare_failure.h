#pragma once
// The probability of a rare failure of a capture: [rare] of a study, by subset simulation. The points are chosen in the
// space of independent standard normal numbers, one for each coordinate of the uncertain inputs, and turned into their
// values by the distributions. Thread contract: any thread may call these functions.

#include <string>

#include "engine/statistics/interval.h"
#include "engine/statistics/subset_simulation.h"
#include "engine/study/optimisation.h"
#include "engine/study/study.h"

namespace netpocket {

struct RareFailure {
  SubsetResult result;
  Interval interval;  // of the probability, with the study's confidence (subset_interval)
  // Points that count as no failure because they have no number: refused ones, and runs without a value of the column.
  std::size_t refused = 0;
  std::size_t not_measured = 0;
};

// Number of points if all levels are taken.
std::size_t planned_rare_points(const Study& study);

RareFailure find_rare_failure(const Study& study, const RunPoints& run);

// Value of the column at which a level's share of the draws fails.
double level_value(const Study& study, const SubsetLevel& level);

// Interval of a level's probability, as `RareFailure::interval`.
Interval level_interval(const Study& study, const SubsetLevel& level);

// "escape_depth <= 0.2"
std::string failure_name(const StudyRareFailure& rare);

// A row for each level: level, value of the column, probability and its interval.
std::string rare_failure_csv(const Study& study, const RareFailure& failure);
// Some lines for people.
std::string rare_failure_text(const Study& study, const RareFailure& failure);
// Markdown.
std::string rare_failure_report(const Study& study, const RareFailure& failure);

}  // namespace netpocket
