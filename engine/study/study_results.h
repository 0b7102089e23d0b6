#pragma once
// The finished table of a study, read back for figures. Thread contract: any thread may call these functions.

#include <string>
#include <vector>

namespace netpocket {

struct ResultColumn {
  std::string name;
  std::string unit;
  std::vector<double> values;  // by row; NaN where there is no number
};

// Rows of runs; refused points are left out.
struct StudyResults {
  std::vector<ResultColumn> inputs;             // settings that differ and uncertain values, as far as they are numbers
  std::vector<ResultColumn> measures;           // numbers of the summary and metrics
  std::vector<double> points;                   // 1, 2, ...
  std::vector<double> captured;                 // 1 or 0; NaN where it was not judged
  std::vector<ResultColumn> sensitivity;        // columns of study_sensitivity.csv, of the first group and variant
  std::vector<std::string> sensitivity_inputs;  // names, by row of these columns
  std::string sensitivity_of;                   // column that the indices are of
  std::vector<ResultColumn> optimisation;       // columns of study_optimisation.csv of a search that came to its end
  std::vector<ResultColumn> rare;               // of study_rare.csv, likewise
  std::string objective, failure;               // as the study's manifest has them

  std::size_t size() const { return points.size(); }
  // Null when there is no such input or measure.
  const ResultColumn* find(const std::string& name) const;
};

// Reads study.csv and study_columns.csv of a study's folder, and what a search has added to them. Throws FileError with
// one sentence when there are none or when they are damaged.
StudyResults read_study_results(const std::string& folder);

}  // namespace netpocket
