#include <fmt/format.h>

#include <memory>

#include "gui/commands/command.h"
#include "gui/commands/model_report.h"
#include "gui/commands/options.h"
#include "gui/commands/standard_streams.h"

namespace netpocket {

Action declare_check(CLI::App& app) {
  const auto choice = std::make_shared<ScenarioChoice>();
  add_scenario_options(app, *choice);
  app.footer(R"(Examples:
  netpocket check scenarios/case1.toml
  netpocket check scenarios/case1.toml --set pocket.mesh_rows=12

)" + exit_code_help({ExitCode::bad_input}));
  return [choice](const std::string&) {
    print(model_report(load_scenario(*choice)));
    return ExitCode::ok;
  };
}

}  // namespace netpocket
