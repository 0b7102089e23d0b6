#include <fmt/format.h>

#include <array>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>

#include "engine/analysis/csv.h"
#include "engine/analysis/metrics/metrics.h"
#include "engine/analysis/report.h"
#include "engine/base/folder.h"
#include "engine/base/output_list.h"
#include "engine/base/whole_file.h"
#include "engine/capture/recorded_scenario.h"
#include "engine/scenario/scenario_json.h"
#include "gui/commands/command.h"
#include "gui/commands/interrupt.h"
#include "gui/commands/notes.h"
#include "gui/commands/options.h"
#include "gui/commands/progress_line.h"
#include "gui/commands/recordings.h"
#include "gui/commands/standard_streams.h"
#include "render/output/export_vtp.h"

namespace netpocket {
namespace {

constexpr const char* kExportHelp = R"(--csv writes channels.csv: one row for each recorded frame.
--json writes summary.json, metrics.json and scenario.json: what info, metrics and check print with --json.
--vtp writes netpocket.pvd, for ParaView: cords and rods with tension, strain and velocity, and the bodies.

Examples:
  netpocket export case1.h5 --csv case1
  netpocket export case1.h5 --json case1
  netpocket export case1.h5 --vtp case1/paraview

)";

constexpr const char* kSeriesName = "netpocket.pvd";
constexpr const char *kSummary = "summary", *kMetrics = "metrics", *kScenario = "scenario";
constexpr std::array kJsonNames = {kSummary, kMetrics, kScenario};

struct ExportChoice {
  std::string recording;
  std::string csv;
  std::string json;
  std::string vtp;
  bool quiet = false;
};

ExitCode export_series(const Recording& recording, const ExportChoice& choice) {
  const Interrupt interrupt;
  const RenderOutcome outcome = [&] {
    ProgressLine line(!choice.quiet);
    const auto show = [&](const RenderProgress& p) {
      line.update(static_cast<double>(p.done) / static_cast<double>(p.total),
                  fmt::format("frame {} of {}, {} left", p.done, p.total, duration_text(p.seconds_left)));
    };
    return export_vtp(recording, choice.vtp, {}, show, interrupt.token());
  }();
  if (outcome != RenderOutcome::finished) {
    say(fmt::format("interrupted; \"{}/{}\" lists the frames that were written", choice.vtp, kSeriesName));
    return ExitCode::interrupted;
  }
  for (const std::string part : {"lines", "bodies"}) {
    std::set<std::string> files;
    for (std::size_t i = 0; i < recording.frame_count(); ++i) files.insert(vtp_file_name(part, i));
    note_older_files(choice.vtp, part + "_", ".vtp", files);
  }
  return ExitCode::ok;
}

std::string json_file(const ExportChoice& choice, const char* name) {
  return fmt::format("{}/{}.json", choice.json, name);
}

// A recording of a newer version may have a scenario that this program does not read.
void export_json(const Recording& recording, const ExportChoice& choice) {
  const ScenarioResult recorded = recorded_scenario(recording);
  const MetricOptions options =
      recorded.ok() ? metric_options(recorded.scenario, recording.structure()) : MetricOptions{};
  write_whole_file(json_file(choice, kSummary), FileKind::json, summary_json(recording).dump(2) + "\n");
  write_whole_file(json_file(choice, kMetrics), FileKind::json, metrics_json(metrics_of(recording, options)));
  if (!recorded.ok()) {
    say(fmt::format("no \"{}\": {}", json_file(choice, kScenario), recorded.diagnostics.text()));
    return;
  }
  write_whole_file(json_file(choice, kScenario), FileKind::json, scenario_json(recorded.scenario).dump(2) + "\n");
}

ExitCode export_recording(const ExportChoice& choice) {
  if (choice.csv.empty() && choice.json.empty() && choice.vtp.empty()) {
    throw CommandError(ExitCode::usage, "nothing to write: give --csv, --json or --vtp");
  }
  const Recording recording = open_recording(choice.recording);
  const std::string table = choice.csv + "/channels.csv";
  OutputList outputs;
  outputs.add_input(choice.recording);
  if (!choice.csv.empty()) {
    make_folder(choice.csv);
    outputs.add("--csv", table, FileKind::csv);
  }
  if (!choice.json.empty()) {
    make_folder(choice.json);
    for (const char* name : kJsonNames) outputs.add("--json", json_file(choice, name), FileKind::json);
  }
  if (!choice.vtp.empty()) {
    make_folder(choice.vtp);
    outputs.add("--vtp", fmt::format("{}/{}", choice.vtp, kSeriesName), FileKind::pvd);
  }
  if (!choice.csv.empty()) write_channels_csv(recording, table);
  if (!choice.json.empty()) export_json(recording, choice);
  return choice.vtp.empty() ? ExitCode::ok : export_series(recording, choice);
}

}  // namespace

Action declare_export(CLI::App& app) {
  const auto choice = std::make_shared<ExportChoice>();
  app.add_option("RUN.h5", choice->recording, "recording to export")->required()->type_name("FILE");
  app.add_option("--csv", choice->csv, "folder for channels.csv")->type_name("DIR");
  app.add_option("--json", choice->json, "folder for summary, metrics and scenario as JSON")->type_name("DIR");
  app.add_option("--vtp", choice->vtp, "folder for a series that ParaView opens")->type_name("DIR");
  app.add_flag("--quiet", choice->quiet, "no progress");
  app.footer(kExportHelp +
             exit_code_help({ExitCode::bad_input, ExitCode::io, ExitCode::rendering, ExitCode::interrupted}));
  return [choice](const std::string&) { return export_recording(*choice); };
}

}  // namespace netpocket
