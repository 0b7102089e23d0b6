#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "engine/analysis/report.h"
#include "engine/recording/verify.h"
#include "gui/commands/command.h"
#include "gui/commands/recordings.h"
#include "gui/commands/standard_streams.h"

namespace netpocket {
namespace {

struct InfoChoice {
  std::string recording;
  bool json = false;
  bool verify = false;
};

ExitCode verify(const std::string& path) {
  const Verification result = [&] {
    try {
      return verify_recording(path);
    } catch (const RecordingError& error) {
      throw CommandError(ExitCode::bad_input, error.what());
    }
  }();
  for (const std::string& problem : result.problems) say(problem);
  print(fmt::format("{}: {} frames, {} checkpoints, {} chunks of {} bytes: {}\n", path, result.frames,
                    result.checkpoints, result.chunks, result.bytes,
                    result.ok() ? "all checksums are right" : "damaged"));
  return result.ok() ? ExitCode::ok : ExitCode::bad_input;
}

}  // namespace

Action declare_info(CLI::App& app) {
  const auto choice = std::make_shared<InfoChoice>();
  app.add_option("RUN.h5", choice->recording, "recording to describe")->required()->type_name("FILE");
  app.add_flag("--json", choice->json, "for programs: one JSON object, SI units");
  app.add_flag("--verify", choice->verify, "read all of it and compute every checksum");
  app.footer(R"(Examples:
  netpocket info case1.h5
  netpocket info case1.h5 --verify
  netpocket info case1.h5 --json

)" + exit_code_help({ExitCode::bad_input}));
  return [choice](const std::string&) {
    if (choice->verify) return verify(choice->recording);
    const Recording recording = open_recording(choice->recording);
    print(choice->json ? summary_json(recording).dump(2) + "\n" : summary_text(recording));
    return ExitCode::ok;
  };
}

}  // namespace netpocket
