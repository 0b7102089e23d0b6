#include <fmt/format.h>

#include <algorithm>

#include "gui/commands/command.h"
#include "gui/commands/standard_streams.h"
#include "render/gl/gl_host.h"

namespace netpocket {

Action declare_backends(CLI::App& app) {
  app.footer(R"(Examples:
  netpocket backends

)" + exit_code_help({ExitCode::rendering}));
  return [](const std::string&) {
    const auto reports = available_backends();
    for (const GlBackendReport& report : reports) {
      print(
          fmt::format("{:<8}{:<15}{}\n", report.name, report.available ? "available" : "not available", report.detail));
    }
    const bool any = std::any_of(reports.begin(), reports.end(), [](const auto& report) { return report.available; });
    return any ? ExitCode::ok : ExitCode::rendering;
  };
}

}  // namespace netpocket
