#include "gui/workbench/editor/part_presets.h"

#include <QCoreApplication>
#include <algorithm>
#include <array>

#include "engine/scenario/read_scenario.h"
#include "gui/workbench/editor/parameter_words.h"
#include "gui/workbench/editor/presets.h"

namespace netpocket {
namespace {

struct PartWords {
  Q_DECLARE_TR_FUNCTIONS(PartPresets)
};

std::vector<std::string_view> groups_of(ScenarioPart part) {
  switch (part) {
    case ScenarioPart::pocket:
      return {"pocket", "net", "rope", "rods"};
    case ScenarioPart::target:
      return {"target"};
    case ScenarioPart::strategy:
      break;
  }
  return {"closing", "towing"};
}

QString value_of(std::string_view key, const Scenario& scenario) {
  const Parameter& parameter = *find_parameter(key, scenario);
  return value_words(parameter, parameter.get(scenario));
}

QString pocket_summary(const Scenario& scenario) {
  return PartWords::tr("%1 rods, meshes %2 × %3, tip at %4 m")
      .arg(value_of("pocket.rod_count", scenario), value_of("pocket.mesh_columns", scenario),
           value_of("pocket.mesh_rows", scenario), number_words(scenario.rods.profile.back().y()));
}

QString target_summary(const Scenario& scenario) {
  QStringList facts = {value_of("target.shape", scenario)};
  for (const std::string_view key : {"target.radius", "target.size", "target.length", "target.span"}) {
    if (!why_unused(*find_parameter(key, scenario), scenario)) facts << value_of(key, scenario);
  }
  facts << value_of("target.mass", scenario);
  if (!scenario.target.spin.isZero()) facts << value_of("target.spin", scenario);
  return facts.join(", ");
}

QString strategy_summary(const Scenario& scenario) {
  return PartWords::tr("closing: %1, %2; towing: %3 from %4")
      .arg(value_of("closing.law", scenario), value_of("closing.duration", scenario), value_of("towing.mode", scenario),
           value_of("towing.start", scenario));
}

std::vector<ScenarioDocument::Setting> settings_of(ScenarioPart part, const Scenario& scenario) {
  const std::vector<std::string_view> groups = groups_of(part);
  std::vector<ScenarioDocument::Setting> settings;
  for (const Parameter& parameter : parameters()) {
    if (std::ranges::find(groups, parameter.group()) == groups.end()) continue;
    settings.emplace_back(&parameter, parameter.get(scenario));
  }
  return settings;
}

std::vector<PartPreset> read_parts(ScenarioPart part) {
  std::vector<PartPreset> found;
  for (const Preset& preset : presets()) {
    const Scenario scenario = read_scenario_text(preset.text.toStdString(), {}).scenario;
    if (scenario.system != kPocketSystem) continue;
    auto settings = settings_of(part, scenario);
    const auto same = [&](const PartPreset& other) { return other.settings == settings; };
    if (const auto place = std::ranges::find_if(found, same); place != found.end()) {
      place->scenarios << preset.name;
    } else {
      found.push_back({preset.name, {preset.name}, scenario, std::move(settings)});
    }
  }
  return found;
}

}  // namespace

QString summary_of(ScenarioPart part, const PartPreset& preset) {
  switch (part) {
    case ScenarioPart::pocket:
      return pocket_summary(preset.scenario);
    case ScenarioPart::target:
      return target_summary(preset.scenario);
    case ScenarioPart::strategy:
      break;
  }
  return strategy_summary(preset.scenario);
}

const std::vector<PartPreset>& part_presets(ScenarioPart part) {
  static const std::array<std::vector<PartPreset>, 3> all = {
      read_parts(ScenarioPart::pocket), read_parts(ScenarioPart::target), read_parts(ScenarioPart::strategy)};
  return all[static_cast<std::size_t>(part)];
}

std::vector<ScenarioDocument::Setting> changes(const PartPreset& preset, const Scenario& scenario) {
  std::vector<ScenarioDocument::Setting> changed;
  if (scenario.system != kPocketSystem) return changed;
  for (const ScenarioDocument::Setting& setting : preset.settings) {
    if (setting.first->get(scenario) != setting.second) changed.push_back(setting);
  }
  return changed;
}

}  // namespace netpocket
