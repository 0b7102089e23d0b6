#include "engine/capture/recorded_scenario.h"

#include "engine/recording/recording.h"
#include "engine/scenario/target_shape.h"

namespace netpocket {

ScenarioResult recorded_scenario(const Recording& recording) {
  ScenarioResult result = read_scenario_text(recording.origin().scenario_text, recording.path());
  for (const StructureBody& body : recording.structure().bodies) {
    if (body.role == BodyRole::target) keep_mesh(result.scenario, body.shape);
  }
  return result;
}

}  // namespace netpocket
