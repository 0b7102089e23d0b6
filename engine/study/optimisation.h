#pragma once
// Searches for the values of parameters at which a capture is best: [optimise] of a study, by CMA-ES.
//
// All candidates run with the same draws of the uncertain inputs (common random numbers), so that candidates differ by
// their values and not by their luck. That favours values that suit these draws; base and best candidate are
// therefore compared in the end with draws that the search has not seen. Constraints: a candidate that meets them is
// better than any that does not, and of two that do not the one that violates them less (Deb 2000, Comput. Methods
// Appl. Mech. Eng. 186, doi:10.1016/S0045-7825(99)00389-8); CMA-ES compares candidates only, so it takes this order as
// it is. Thread contract: any thread may call these functions.

#include <functional>
#include <string>
#include <vector>

#include "engine/statistics/interval.h"
#include "engine/study/study.h"
#include "engine/study/study_record.h"

namespace netpocket {

// Runs points and returns their records, in their order.
using RunPoints = std::function<std::vector<StudyRecord>(const std::vector<StudyPoint>&)>;

// A value over draws; NaN if none of them has a number. The interval has the study's confidence: Wilson's for the share
// of captures, by order statistics for a quantile, else that of a mean of many values.
struct EstimatedValue {
  double value = 0;
  Interval interval;
};

struct Candidate {
  int generation = 0;  // 1, 2, ...; 0: the base
  std::vector<Setting> settings;
  double objective = 0;
  std::vector<double> constraints;  // values, in their order
  double violation = 0;  // sum over the constraints of what is missing, by the size of the limit; infinite: not judged

  bool is_feasible() const { return violation == 0; }
};

struct Optimisation {
  std::vector<Candidate> candidates;  // in the order in which they were run; the first is the base
  std::size_t best = 0;
  int restarts = 0;
  // Objective and constraints of base and best candidate with fresh draws; empty without uncertain inputs.
  std::vector<EstimatedValue> before, after;
};

// Number of points that a search takes which neither converges nor restarts: whole generations.
std::size_t planned_points(const Study& study);

Optimisation optimise(const Study& study, const RunPoints& run);

// "mean of load_body": what is made least or largest.
std::string objective_name(const StudyOptimisation& search);

// The base with the best candidate's values.
Scenario best_scenario(const Study& study, const Optimisation& result);

// A row for each candidate: candidate (0: the base), generation, its values, objective, constraints, violation,
// is_feasible, best_so_far (objective of the best until here; empty while none is feasible).
std::string optimisation_csv(const Study& study, const Optimisation& result);
// Some lines for people.
std::string optimisation_text(const Study& study, const Optimisation& result);
// Markdown.
std::string optimisation_report(const Study& study, const Optimisation& result);

}  // namespace netpocket
