#include "gui/workbench/placement_actions.h"

#include <algorithm>

namespace netpocket {

PlacementActions::PlacementActions(Viewport& viewport, ScenarioDocument& document, QObject* parent)
    : QObject(parent), document_(document) {
  connect(&viewport, &Viewport::body_drag_started, &document_, &ScenarioDocument::begin_interaction);
  connect(&viewport, &Viewport::body_drag_ended, &document_, &ScenarioDocument::end_interaction);
  connect(&viewport, &Viewport::body_dragged, this, &PlacementActions::place);
}

void PlacementActions::place(BodyRole role, const Eigen::Vector3d& position) {
  const bool target = role == BodyRole::target;
  const Parameter* parameter =
      find_parameter(target ? "target.position" : "spacecraft.position", document_.scenario().system);
  if (parameter == nullptr) return;  // the system has no such body
  const auto limit = [&](double x) { return std::clamp(x, parameter->limits.minimum, parameter->limits.maximum); };
  // Within its limits nothing else can refuse a position; what it collides with, the editor says.
  (void)document_.set_value(*parameter, Eigen::Vector3d(position.unaryExpr(limit)));
}

}  // namespace netpocket
