#pragma once
// What a campaign estimates from its captures: the probability of capture and quantiles of what was measured, with
// intervals. The captures of a group, one combination of place and axes, differ in their uncertain inputs only.
// Thread contract: one thread at a time per object.

#include <map>
#include <string>
#include <vector>

#include "engine/statistics/interval.h"
#include "engine/study/study_plan.h"
#include "engine/study/study_record.h"

namespace netpocket {

// How many captures of a variant worked.
struct CaptureTally {
  std::int64_t captured = 0;
  std::int64_t judged = 0;      // captured or not
  std::int64_t not_judged = 0;  // diverged, at their limit of steps, or too short to say

  void add(const StudyRecord& run);
};

struct QuantileOfColumn {
  std::string column;
  double fraction = 0;
  std::int64_t count = 0;  // values behind it
  double value = 0;
  Interval interval;  // an end is infinite where the values are too few to bound it
};

// "3 to 4"; "at least 3" or "at most 4" where an end is not known, as it lies beyond all values.
std::string interval_text(const Interval& interval);

struct GroupEstimate {
  std::size_t group = 0;  // index as in StudyPlan::group_count()
  std::string variant;
  std::int64_t refused = 0;  // points
  CaptureTally tally;
  Interval wilson, clopper_pearson;  // of the probability; 0 to 1 if nothing was judged
  std::vector<QuantileOfColumn> quantiles;

  double probability() const;  // NaN if nothing was judged
};

class CampaignEstimator {
 public:
  // The study must outlive the object.
  explicit CampaignEstimator(const Study& study) : study_(study), plan_(study) {}

  void add(const StudyRecord& record);
  // By group and variant.
  std::vector<GroupEstimate> estimates() const;

 private:
  struct Sample {
    std::int64_t refused = 0;
    CaptureTally tally;
    std::vector<std::vector<double>> values;  // by column of StudyEstimate::of
  };
  GroupEstimate estimate(std::size_t group, const std::string& variant, const Sample& sample) const;

  const Study& study_;
  const StudyPlan plan_;
  std::map<std::pair<std::size_t, std::size_t>, Sample> samples_;  // by group and variant
};

// Some lines for people. Groups beyond the first twenty are counted.
std::string estimates_text(const Study& study, const std::vector<GroupEstimate>& estimates);
// A row for each probability and quantile: first point of the group, place, variant, of, statistic, value, lower,
// upper, count, not_judged, refused.
std::string estimates_csv(const Study& study, const std::vector<GroupEstimate>& estimates);

}  // namespace netpocket
