#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "engine/scenario/scenario_json.h"
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
    print(choice->json ? scenario_json(scenario).dump(2) + "\n" : model_report(scenario));
    return ExitCode::ok;
  };
}

}  // namespace netpocket
