#include "engine/study/found_records.h"

#include "engine/study/study_record.h"

namespace netpocket {
namespace {

// Joins the lines of a text.
std::string in_one_line(std::string text) {
  for (auto end = text.find('\n'); end != text.npos; end = text.find('\n', end)) text.replace(end, 1, "; ");
  return text;
}

}  // namespace

PreparedPoint prepare_point(const Study& study, std::size_t index, StudyPoint point, const std::string& program,
                            PointCheck check) {
  PreparedPoint made{index, std::move(point), {}, {}, {}};
  const auto make = check == PointCheck::full ? study_scenario : unchecked_scenario;
  for (const NamedSettings& variant : study.variants) {
    StudyScenario scenario = make(study, made.point, variant);
    if (!scenario.diagnostics.ok() && made.problem.empty()) made.problem = in_one_line(scenario.diagnostics.text());
    made.scenarios.push_back(std::move(scenario.scenario));
  }
  made.identity = point_identity(made.scenarios, program);
  return made;
}

PreparedPoint prepare_point(const Study& study, const StudyPlan& plan, std::size_t index, const std::string& program,
                            PointCheck check) {
  return prepare_point(study, index, plan.point(index), program, check);
}

FoundRecords::FoundRecords(const std::string& folder) {
  scan_records(folder, [this](const RecordPlace& place) { places_[place.point - 1].push_back(place); });
}

std::optional<RecordPlace> FoundRecords::find(std::size_t index, const std::string& identity) const {
  const auto found = places_.find(index);
  if (found == places_.end()) return std::nullopt;
  for (auto place = found->second.rbegin(); place != found->second.rend(); ++place) {
    if (place->identity == identity) return *place;
  }
  return std::nullopt;
}

std::vector<std::size_t> missing_points(const Study& study, const std::string& folder, const std::string& program) {
  const FoundRecords found(folder);
  const StudyPlan plan(study);
  std::vector<std::size_t> missing;
  for (std::size_t i = 0; i < plan.size(); ++i) {
    if (!found.find(i, prepare_point(study, plan, i, program, PointCheck::none).identity)) missing.push_back(i);
  }
  return missing;
}

}  // namespace netpocket
