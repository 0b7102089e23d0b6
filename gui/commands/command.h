#pragma once
// A subcommand of the program: it declares its options and, when chosen, acts. A command parses options, calls the
// library and prints; what it does belongs in the library.

#include <CLI/CLI.hpp>
#include <functional>
#include <stdexcept>
#include <string>

#include "gui/commands/exit_code.h"

namespace netpocket {

// What() is one sentence, or one for each problem, a line each.
class CommandError : public std::runtime_error {
 public:
  CommandError(ExitCode code, const std::string& message) : std::runtime_error(message), code_(code) {}
  ExitCode code() const { return code_; }

 private:
  ExitCode code_;
};

// Runs the command with the options that were parsed; `command_line` is what the user typed.
using Action = std::function<ExitCode(const std::string& command_line)>;

struct Command {
  const char* name;
  const char* summary;               // one line
  Action (*declare)(CLI::App& app);  // adds the options to the command's own parser
};

Action declare_run(CLI::App& app);
Action declare_check(CLI::App& app);
Action declare_render(CLI::App& app);
Action declare_plot(CLI::App& app);
Action declare_report(CLI::App& app);
Action declare_export(CLI::App& app);
Action declare_info(CLI::App& app);
Action declare_metrics(CLI::App& app);
Action declare_findings(CLI::App& app);
Action declare_study(CLI::App& app);
Action declare_mesh(CLI::App& app);
Action declare_backends(CLI::App& app);
Action declare_workbench(CLI::App& app);  // in programs built with the workbench

}  // namespace netpocket
