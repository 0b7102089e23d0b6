#include <fmt/format.h>

#include <memory>

#include "engine/analysis/metrics/metrics.h"
#include "engine/capture/recorded_scenario.h"
#include "gui/commands/command.h"
#include "gui/commands/recordings.h"
#include "gui/commands/standard_streams.h"

namespace netpocket {
namespace {

struct MetricsChoice {
  std::string recording;
  bool csv = false;
  bool json = false;
};

// What the recorded scenario tells of strengths and inertia. Nothing if this program does not read it any more.
MetricOptions options_of(const Recording& recording) {
  const ScenarioResult recorded = recorded_scenario(recording);
  return recorded.ok() ? metric_options(recorded.scenario, recording.structure()) : MetricOptions{};
}

std::string output(const MetricsOfRun& run, const MetricsChoice& choice) {
  if (choice.json) return metrics_json(run);
  if (choice.csv) return metrics_csv(run.metrics);
  return metrics_text(run.metrics) + (run.draft.empty() ? "" : "draft: " + run.draft + "\n");
}

MetricsOfRun measure(const std::string& path) {
  const Recording recording = open_recording(path);
  try {
    return metrics_of(recording, options_of(recording));
  } catch (const RecordingError& error) {
    throw CommandError(ExitCode::bad_input, error.what());
  }
}

}  // namespace

Action declare_metrics(CLI::App& app) {
  const auto choice = std::make_shared<MetricsChoice>();
  app.add_option("RUN.h5", choice->recording, "recording to measure")->required()->type_name("FILE");
  CLI::Option* csv = app.add_flag("--csv", choice->csv, "for programs: a header line and a line per metric");
  app.add_flag("--json", choice->json, "for programs: one JSON object, with mouth and hull over time")->excludes(csv);
  app.footer(
      R"(How the mouth closed, how well the net encloses the target, how near it came to escape, how hard cords and target
were loaded. A - means that there is no such number: it did not happen, or was not recorded. Cords are taken to break
at a strain of 3.5 %, as aramid fibres do.

Examples:
  netpocket metrics case1.h5
  netpocket metrics case1.h5 --csv > case1.csv
  netpocket metrics case1.h5 --json

)" + exit_code_help({ExitCode::bad_input}));
  return [choice](const std::string&) {
    const MetricsOfRun run = measure(choice->recording);
    print(output(run, *choice));
    if (choice->csv && !run.draft.empty()) say(fmt::format("\"{}\" is a draft: {}", choice->recording, run.draft));
    return ExitCode::ok;
  };
}

}  // namespace netpocket
