#include <fmt/format.h>

#include <cstdlib>
#include <memory>

#include "gui/commands/command.h"
#include "gui/commands/options.h"
#include "gui/commands/standard_streams.h"
#include "gui/commands/version.h"
#include "gui/workbench/workbench.h"

namespace netpocket {

Action declare_workbench(CLI::App& app) {
  const auto options = std::make_shared<WorkbenchOptions>();
  app.add_option("FILE", options->file, "scenario (.toml), recording (.h5) or folder of a study to open");
  app.add_option(
         "--presenter", options->presenter,
         "how the window draws: auto, opengl, or image: drawn in the background (default: as in the preferences)")
      ->type_name("")
      ->check(one_of({"auto", "opengl", "image"}));
  app.add_option("--threads", options->threads,
                 "threads of a simulation; the result is the same for any number (default: as in the preferences)")
      ->type_name("N")
      ->check(whole_number(1, 256));
  app.add_option("--screenshot", options->screenshot, "save a picture of the window (PNG) once it shows FILE, and end")
      ->type_name("PNG");
  app.footer(R"(Needs a display; QT_QPA_PLATFORM=offscreen works without one.

Examples:
  netpocket
  netpocket workbench scenarios/case2.toml
  netpocket workbench case1.h5
  netpocket workbench campaign

)" + exit_code_help({ExitCode::rendering}));
  return [options](const std::string&) {
    options->version = program_version();
    options->commit = program_commit();
    options->version_text = version_text();
    options->no_display = [](const std::string& reason) {
      say(reason);
      std::_Exit(static_cast<int>(ExitCode::rendering));
    };
    try {
      return run_workbench(*options) == 0 ? ExitCode::ok : ExitCode::io;
    } catch (const NoDisplay& error) {
      throw CommandError(ExitCode::rendering, error.what());
    }
  };
}

}  // namespace netpocket
