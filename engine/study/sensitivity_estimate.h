#pragma once
// What decides the outcome of captures: Sobol indices or Morris' effects of the uncertain inputs, from the points that
// a study with [sensitivity] runs. Thread contract: one thread at a time per object.

#include <map>
#include <string>
#include <vector>

#include "engine/statistics/screening.h"
#include "engine/statistics/sobol_indices.h"
#include "engine/study/study_plan.h"
#include "engine/study/study_record.h"

namespace netpocket {

// Of one group of points (StudyPlan::group_count) and variant.
struct SensitivityEstimate {
  std::size_t group = 0;
  std::string variant;
  std::size_t outputs = 0;                // points with a finite output
  std::vector<SobolIndices> sobol = {};   // by coordinate; empty for the other method
  std::vector<InputEffect> effects = {};  // likewise
};

class SensitivityEstimator {
 public:
  // The study must outlive the object.
  explicit SensitivityEstimator(const Study& study) : study_(study), plan_(study) {}

  void add(const StudyRecord& record);
  std::vector<SensitivityEstimate> estimates() const;

 private:
  const Study& study_;
  const StudyPlan plan_;
  std::map<std::pair<std::size_t, std::size_t>, Eigen::VectorXd> outputs_;  // by group and variant, by draw
};

// Names of the coordinates of the uncertain inputs: their keys; of a direction "key height", "key angle", "key size".
// Coordinates of correlated inputs are independent numbers from which the inputs are made: "key given those before".
std::vector<std::string> coordinate_names(const Study& study);

std::string sensitivity_text(const Study& study, const std::vector<SensitivityEstimate>& estimates);
// A row for each coordinate: first point of the group, variant, of, input, then first, first_lower, first_upper, total,
// total_lower, total_upper; or mean, mean_absolute, deviation, steps.
std::string sensitivity_csv(const Study& study, const std::vector<SensitivityEstimate>& estimates);

}  // namespace netpocket
