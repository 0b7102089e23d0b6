#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "engine/scenario/read_scenario.h"
#include "engine/scenario/scenario_json.h"
#include "engine/scenario/unused_parameters.h"
#include "gui/commands/command.h"
#include "gui/commands/model_report.h"
#include "gui/commands/options.h"
#include "gui/commands/standard_streams.h"

namespace netpocket {
namespace {

struct CheckChoice {
  ScenarioChoice scenario;
  bool json = false;
};

// The same system with the same lists, and nothing chosen.
Scenario defaults_like(const Scenario& scenario) {
  Scenario defaults;
  defaults.system = scenario.system;
  for (const ParameterList& list : parameter_lists(scenario.system)) list.resize(defaults, list.size(scenario));
  return defaults;
}

// Values that somebody chose and that change nothing, with the line where they stand. They are no faults.
void note_unused(const ScenarioChoice& choice, const Scenario& scenario) {
  const ScenarioResult file = read_scenario_file(choice.path);
  const Scenario defaults = defaults_like(scenario);
  for (const Parameter* parameter : parameters_of(scenario)) {
    const std::string_view reason = why_parameter_unused(*parameter, scenario);
    if (reason.empty() || parameter->get(scenario) == parameter->get(defaults)) continue;
    Diagnostic note;
    note.key = parameter->key;
    note.message = fmt::format("has no effect: {}", reason);
    note.message.pop_back();
    if (const auto line = file.lines.find(parameter->key); line != file.lines.end()) {
      note.file = choice.path;
      note.line = line->second;
    }
    say(note.text());
  }
}

}  // namespace

Action declare_check(CLI::App& app) {
  const auto choice = std::make_shared<CheckChoice>();
  add_scenario_options(app, choice->scenario);
  app.add_flag("--json", choice->json, "for programs: the complete scenario as one JSON object");
  app.footer(R"(Examples:
  netpocket check scenarios/case1.toml
  netpocket check scenarios/case1.toml --set pocket.mesh_rows=12
  netpocket check scenarios/case1.toml --json > case1.json

)" + exit_code_help({ExitCode::bad_input}));
  return [choice](const std::string&) {
    const Scenario scenario = load_scenario(choice->scenario);
    note_unused(choice->scenario, scenario);
    print(choice->json ? scenario_json(scenario).dump(2) + "\n" : model_report(scenario));
    return ExitCode::ok;
  };
}

}  // namespace netpocket
