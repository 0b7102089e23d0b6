#include "gui/commands/command_line.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <csignal>
#include <sstream>

#include "engine/base/file_error.h"
#include "engine/systems/capture_system.h"
#include "gui/commands/command.h"
#include "gui/commands/spelling.h"
#include "gui/commands/standard_streams.h"
#include "gui/commands/version.h"
#ifdef NETPOCKET_WORKBENCH
#include "gui/workbench/workbench.h"
#endif
#include "render/figures/figure_error.h"
#include "render/render_error.h"

namespace netpocket {
namespace {

constexpr std::array kCommands = {
#ifdef NETPOCKET_WORKBENCH
    Command{"workbench", "edit, run and watch captures in a window; also what netpocket does without a command",
            declare_workbench},
#endif
    Command{"run", "simulate a scenario and record it", declare_run},
    Command{"check", "validate a scenario and print the model that follows from it", declare_check},
    Command{"render", "draw pictures, a contact sheet or a video of a recording", declare_render},
    Command{"plot", "draw the paper's figures for one recording or several", declare_plot},
    Command{"report", "one HTML page about a recording or several", declare_report},
    Command{"export", "write a recording for other programs: CSV, JSON, ParaView, glTF", declare_export},
    Command{"info", "what a recording holds and came to", declare_info},
    Command{"metrics", "how well a recorded capture works, in numbers", declare_metrics},
    Command{"findings", "whether recordings show what the paper found", declare_findings},
    Command{"study", "run many variations of a scenario side by side and tabulate them", declare_study},
    Command{"mesh", "tell whether a mesh file can be a target, draw it, and mend what is unambiguous", declare_mesh},
    Command{"backends", "which ways to draw without a display there are", declare_backends},
};

constexpr const char* kFooter = R"(netpocket COMMAND --help tells more and gives examples.

Examples:
  netpocket run scenarios/case1.toml -o case1.h5
  netpocket render case1.h5 --sheet sheet.png
  netpocket plot case1.h5 -o figures

)";

class CommandLine {
 public:
  CommandLine() : app_("Simulates and shows how a netted pocket captures a target in orbit.", "netpocket") {
    app_.get_formatter()->column_width(kHelpColumn);
    app_.set_version_flag("--version", version_text, "print the versions of netpocket and of its libraries");
    app_.footer(kFooter + exit_code_help({ExitCode::unexpected, ExitCode::bad_input, ExitCode::diverged, ExitCode::io,
                                          ExitCode::rendering, ExitCode::interrupted}));
    for (const Command& command : kCommands) {
      CLI::App* parser = app_.add_subcommand(command.name, command.summary);
      actions_.emplace_back(parser, command.declare(*parser));
    }
  }

  ExitCode run(const std::vector<std::string>& arguments) {
#ifdef NETPOCKET_WORKBENCH
    if (arguments.empty() && can_open_window()) return run({"workbench"});
#endif
    check_spelling(arguments);
    // CLI11 takes the arguments in reverse order.
    app_.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
    for (const auto& [parser, action] : actions_) {
      if (parser->parsed()) return action(fmt::format("netpocket {}", fmt::join(arguments, " ")));
    }
    print(app_.help());
    return ExitCode::ok;
  }

  // Help and version also come as an exception.
  ExitCode report(const CLI::ParseError& error) {
    if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) {
      std::ostringstream text, ignored;
      app_.exit(error, text, ignored);
      print(text.str());
      return ExitCode::ok;
    }
    const auto chosen = app_.get_subcommands();
    const std::string name = chosen.empty() ? "netpocket" : "netpocket " + chosen.front()->get_name();
    const std::string message = error.what();
    const std::string help = message.ends_with('?') ? "" : fmt::format("; see {} --help", name);
    throw CommandError(ExitCode::usage, message + help);
  }

 private:
  static constexpr std::size_t kHelpColumn = 34;

  // Before anything else, because a misspelt option also leads to other complaints, such as that an option is missing.
  void check_spelling(const std::vector<std::string>& arguments) const {
    const auto word =
        std::find_if(arguments.begin(), arguments.end(), [](const auto& a) { return !a.starts_with('-'); });
    const CLI::App* parser = &app_;
    if (word != arguments.end()) {
      parser = find_parser(*word);
      if (parser == nullptr) throw unknown("command", *word, command_names(), app_);
    }
    for (auto argument = word == arguments.end() ? arguments.begin() : word; argument != arguments.end(); ++argument) {
      if (*argument == "--") return;
      const std::string name = option_name(*argument);
      if (!name.empty() && parser->get_option_no_throw(name) == nullptr) {
        throw unknown("option", name, option_names(*parser), *parser);
      }
    }
  }

  const CLI::App* find_parser(const std::string& name) const {
    const auto is_it = [&](const auto& entry) { return entry.first->get_name() == name; };
    const auto found = std::find_if(actions_.begin(), actions_.end(), is_it);
    return found == actions_.end() ? nullptr : found->first;
  }

  // "--set" of "--set=x" and "-o" of "-orun.h5"; empty for what is no option.
  static std::string option_name(const std::string& argument) {
    if (argument.starts_with("--")) return argument.substr(0, argument.find('='));
    const bool is_short = argument.size() > 1 && argument[0] == '-' && std::isalpha(argument[1]) != 0;
    return is_short ? argument.substr(0, 2) : "";
  }

  static CommandError unknown(const char* what, const std::string& name, const std::vector<std::string>& names,
                              const CLI::App& parser) {
    const std::string near = suggestion(name, names);
    const bool top = parser.get_parent() == nullptr;
    const std::string help =
        top ? "; see netpocket --help" : fmt::format("; see netpocket {} --help", parser.get_name());
    return {ExitCode::usage, fmt::format("unknown {} \"{}\"{}", what, name, near.empty() ? help : near)};
  }

  static std::vector<std::string> command_names() {
    std::vector<std::string> names;
    names.reserve(std::size(kCommands));
    for (const Command& command : kCommands) names.emplace_back(command.name);
    return names;
  }

  static std::vector<std::string> option_names(const CLI::App& parser) {
    std::vector<std::string> names;
    for (const CLI::Option* option : parser.get_options()) {
      for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    }
    return names;
  }

  CLI::App app_;
  std::vector<std::pair<CLI::App*, Action>> actions_;
};

ExitCode complain(ExitCode code, const std::string& message) {
  std::istringstream lines(message);
  for (std::string line; std::getline(lines, line);) say(line);
  return code;
}

ExitCode run_parsed(CommandLine& program, const std::vector<std::string>& arguments) {
  try {
    return program.run(arguments);
  } catch (const CLI::ParseError& error) {
    return program.report(error);
  }
}

ExitCode run_guarded(const std::vector<std::string>& arguments) {
  try {
    CommandLine program;
    return run_parsed(program, arguments);
  } catch (const CommandError& error) {
    return complain(error.code(), error.what());
  } catch (const OutputRefused& error) {
    return complain(ExitCode::usage, error.what());
  } catch (const FileError& error) {
    return complain(ExitCode::io, error.what());
  } catch (const FigureError& error) {
    return complain(ExitCode::io, error.what());
  } catch (const RenderError& error) {
    return complain(ExitCode::rendering, error.what());
  } catch (const SystemFault& error) {
    return complain(ExitCode::bad_input, error.what());
  } catch (const std::bad_alloc&) {
    return complain(ExitCode::unexpected, "out of memory");
  } catch (const std::exception& error) {
    return complain(ExitCode::unexpected, fmt::format("unexpected error: {}", error.what()));
  }
}

// What went wrong before says more than that its report did not arrive.
ExitCode run_and_flush(const std::vector<std::string>& arguments) {
  const ExitCode code = run_guarded(arguments);
  std::string reason;
  if (!standard_output_failed(reason)) return code;
  complain(ExitCode::io, fmt::format("cannot write to standard output: {}", reason));
  return code == ExitCode::ok ? ExitCode::io : code;
}

}  // namespace

int run_command_line(int argc, const char* const* argv) {
  // A limit on the size of files is an error to report, not a reason to die.
  std::signal(SIGXFSZ, SIG_IGN);
  return static_cast<int>(run_and_flush({argv + std::min(argc, 1), argv + argc}));
}

}  // namespace netpocket
