#include "engine/study/study.h"

#include "engine/scenario/check_scenario.h"
#include "engine/study/study_plan.h"

namespace netpocket {

std::vector<StudyPoint> study_points(const Study& study) {
  const StudyPlan plan(study);
  std::vector<StudyPoint> points;
  for (std::size_t i = 0; i < plan.size(); ++i) points.push_back(plan.point(i));
  return points;
}

StudyScenario unchecked_scenario(const Study& study, const StudyPoint& point, const NamedSettings& variant) {
  StudyScenario result{study.base, {}};
  result.diagnostics = apply_settings(result.scenario, point.settings);
  if (result.diagnostics.ok()) result.diagnostics = apply_settings(result.scenario, variant.settings);
  if (!variant.name.empty()) result.scenario.name = variant.name;
  return result;
}

StudyScenario study_scenario(const Study& study, const StudyPoint& point, const NamedSettings& variant) {
  StudyScenario result = unchecked_scenario(study, point, variant);
  if (result.diagnostics.ok()) result.diagnostics = check_scenario(result.scenario);
  return result;
}

}  // namespace netpocket
