#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "engine/recording/report.h"
#include "gui/commands/command.h"
#include "gui/commands/recordings.h"

namespace netpocket {
namespace {

struct InfoChoice {
  std::string recording;
  bool json = false;
};

}  // namespace

Action declare_info(CLI::App& app) {
  const auto choice = std::make_shared<InfoChoice>();
  app.add_option("RUN.h5", choice->recording, "recording to describe")->required()->type_name("FILE");
  app.add_flag("--json", choice->json, "for programs: one JSON object, SI units");
  app.footer(R"(Examples:
  netpocket info case1.h5
  netpocket info case1.h5 --json

)" + exit_code_help({ExitCode::bad_input}));
  return [choice](const std::string&) {
    const Recording recording = open_recording(choice->recording);
    fmt::print("{}", choice->json ? summary_json(recording).dump(2) + "\n" : summary_text(recording));
    return ExitCode::ok;
  };
}

}  // namespace netpocket
