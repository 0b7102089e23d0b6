#pragma once
// What a study's folder already holds of the points of a study.

#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "engine/study/record_files.h"
#include "engine/study/study_plan.h"

namespace netpocket {

// The scenarios of a point.
struct PreparedPoint {
  std::size_t index = 0;  // from 0
  StudyPoint point;
  std::vector<Scenario> scenarios;  // by variant
  std::string identity;             // point_identity() of them
  std::string problem;              // why the point cannot be run; empty if it can
};

enum class PointCheck { full, none };  // `none` leaves check_scenario out, which takes much longer than all the rest

PreparedPoint prepare_point(const Study& study, std::size_t index, StudyPoint point, const std::string& program,
                            PointCheck check);
PreparedPoint prepare_point(const Study& study, const StudyPlan& plan, std::size_t index, const std::string& program,
                            PointCheck check);

// Records on disk by point. Of several records of a point the last of the right identity counts. Immutable: any thread
// may use it. Throws FileError.
class FoundRecords {
 public:
  explicit FoundRecords(const std::string& folder);

  std::optional<RecordPlace> find(std::size_t index, const std::string& identity) const;
  // Number of points with a record of any identity.
  std::size_t size() const { return places_.size(); }

 private:
  std::unordered_map<std::size_t, std::vector<RecordPlace>> places_;
};

// Indices of the points that have no record of their present scenario and program.
std::vector<std::size_t> missing_points(const Study& study, const std::string& folder, const std::string& program);

}  // namespace netpocket
