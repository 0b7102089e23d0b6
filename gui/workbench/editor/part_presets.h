#pragma once
// Pockets, targets and strategies of the scenarios that come with the program, to be put into another scenario.

#include <QStringList>
#include <vector>

#include "gui/workbench/editor/scenario_document.h"

namespace netpocket {

enum class ScenarioPart { pocket, target, strategy };

struct PartPreset {
  QString name;           // of the first scenario that has it
  QStringList scenarios;  // all that have the same
  Scenario scenario;      // that one
  std::vector<ScenarioDocument::Setting> settings;
};

// Those of the pocket's capture system, each once, in the order of presets().
const std::vector<PartPreset>& part_presets(ScenarioPart part);

// In the language of the window: "sphere, radius 4.2 m, 200 kg".
QString summary_of(ScenarioPart part, const PartPreset& preset);

// The settings that would change something.
std::vector<ScenarioDocument::Setting> changes(const PartPreset& preset, const Scenario& scenario);

}  // namespace netpocket
