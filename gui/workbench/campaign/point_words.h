#pragma once
// A capture of a campaign in words. Pure functions.

#include <QString>

#include "engine/study/study_results.h"

namespace netpocket {

// "captured", "missed", "not judged"
QString outcome_words(double captured);

// HTML: the point's number, its outcome, its inputs and what was measured that matters most.
QString point_words(const StudyResults& results, std::size_t row);

// "Probability of capture 0.532 (95 %: 0.511 to 0.554)", and from how many; what is known if nothing was judged.
QString estimate_words(std::int64_t captured, std::int64_t judged);

// "40 s", "12 min", "3 h 20 min"
QString time_words(double seconds);

}  // namespace netpocket
