#pragma once
// Lets target and spacecraft be dragged in the view: a drag edits where the capture starts, as one step of the history.
// Thread contract: the user interface's thread.

#include <QObject>

#include "gui/workbench/editor/scenario_document.h"
#include "gui/workbench/viewport/viewport.h"

namespace netpocket {

class PlacementActions : public QObject {
  Q_OBJECT
 public:
  PlacementActions(Viewport& viewport, ScenarioDocument& document, QObject* parent);

 private:
  void place(BodyRole role, const Eigen::Vector3d& position);

  ScenarioDocument& document_;
};

}  // namespace netpocket
