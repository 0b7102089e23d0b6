#include <fmt/format.h>

#include <algorithm>
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
#include "render/output/export_vtkhdf.h"
#include "render/output/export_vtp.h"
#include "render/output/run_meshes.h"
#include "render/output/write_animation.h"

namespace netpocket {
namespace {

constexpr const char* kExportHelp = R"(--csv writes channels.csv: one row for each recorded frame.
--json writes summary.json, metrics.json and scenario.json: what info, metrics and check print with --json.
--vtp writes netpocket.pvd, for ParaView: cords and rods with tension, strain and velocity, the bodies, and ropes that
run through rings or off a drum.
--vtkhdf writes the same as lines.vtkhdf, bodies.vtkhdf and ropes.vtkhdf, with all times in one file each (ParaView 5.12,
VTK 9.3). There is no ropes.vtkhdf for a run without such ropes.
--gltf writes the whole capture as an animation for browsers, Blender and slides. Without --keys it has at most 300
moments, evenly spread; viewers interpolate between them.

Examples:
  netpocket export case1.h5 --csv case1
  netpocket export case1.h5 --json case1
  netpocket export case1.h5 --vtp case1/paraview
  netpocket export case1.h5 --vtkhdf case1
  netpocket export case1.h5 --gltf case1.glb

)";

constexpr const char* kSeriesName = "netpocket.pvd";
constexpr const char *kSummary = "summary", *kMetrics = "metrics", *kScenario = "scenario";
constexpr std::array kJsonNames = {kSummary, kMetrics, kScenario};

struct ExportChoice {
  std::string recording;
  std::string csv;
  std::string json;
  std::string vtp;
  std::string vtkhdf;
  std::string gltf;
  int keys = AnimationOptions().most_keys;
  bool quiet = false;
};

// Shows how far an export is, and ends it when the user does.
template <typename Export>
RenderOutcome with_progress(const ExportChoice& choice, const Export& export_frames) {
  const Interrupt interrupt;
  ProgressLine line(!choice.quiet);
  const auto show = [&](const RenderProgress& p) {
    line.update(static_cast<double>(p.done) / static_cast<double>(p.total),
                fmt::format("frame {} of {}, {} left", p.done, p.total, duration_text(p.seconds_left)));
  };
  return export_frames(show, interrupt.token());
}

ExitCode export_series(const Recording& recording, const ExportChoice& choice) {
  const RenderOutcome outcome = with_progress(choice, [&](const auto& show, const std::stop_token& stop) {
    return export_vtp(recording, choice.vtp, {}, show, stop);
  });
  if (outcome != RenderOutcome::finished) {
    say(fmt::format("interrupted; \"{}/{}\" lists the frames that were written", choice.vtp, kSeriesName));
    return ExitCode::interrupted;
  }
  const std::vector<RunPart> parts = run_parts(recording.structure());
  for (const RunPart part : kRunParts) {
    const std::string name = run_part_name(part);
    std::set<std::string> files;
    if (std::ranges::find(parts, part) != parts.end()) {
      for (std::size_t i = 0; i < recording.frame_count(); ++i) files.insert(vtp_file_name(name, i));
    }
    note_older_files(choice.vtp, name + "_", ".vtp", files);
  }
  return ExitCode::ok;
}

ExitCode when_interrupted(const std::string& target) {
  say(fmt::format("interrupted; nothing was written to \"{}\"", target));
  return ExitCode::interrupted;
}

ExitCode export_animation(const Recording& recording, const ExportChoice& choice) {
  const RenderOutcome outcome = with_progress(choice, [&](const auto& show, const std::stop_token& stop) {
    return write_animation(recording, choice.gltf, {choice.keys}, show, stop);
  });
  return outcome == RenderOutcome::finished ? ExitCode::ok : when_interrupted(choice.gltf);
}

ExitCode export_steps(const Recording& recording, const ExportChoice& choice) {
  const RenderOutcome outcome = with_progress(choice, [&](const auto& show, const std::stop_token& stop) {
    return export_vtkhdf(recording, choice.vtkhdf, show, stop);
  });
  return outcome == RenderOutcome::finished ? ExitCode::ok : when_interrupted(choice.vtkhdf);
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
  if (choice.csv.empty() && choice.json.empty() && choice.vtp.empty() && choice.vtkhdf.empty() && choice.gltf.empty()) {
    throw CommandError(ExitCode::usage, "nothing to write: give --csv, --json, --vtp, --vtkhdf or --gltf");
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
  if (!choice.vtkhdf.empty()) {
    make_folder(choice.vtkhdf);
    for (const std::string& file : vtkhdf_files(recording, choice.vtkhdf)) {
      outputs.add("--vtkhdf", file, FileKind::vtkhdf);
    }
  }
  if (!choice.gltf.empty()) outputs.add("--gltf", choice.gltf, FileKind::gltf);
  if (!choice.csv.empty()) write_channels_csv(recording, table);
  if (!choice.json.empty()) export_json(recording, choice);
  ExitCode result = ExitCode::ok;
  if (!choice.vtp.empty()) result = export_series(recording, choice);
  if (result == ExitCode::ok && !choice.vtkhdf.empty()) result = export_steps(recording, choice);
  if (result == ExitCode::ok && !choice.gltf.empty()) result = export_animation(recording, choice);
  return result;
}

}  // namespace

Action declare_export(CLI::App& app) {
  const auto choice = std::make_shared<ExportChoice>();
  app.add_option("RUN.h5", choice->recording, "recording to export")->required()->type_name("FILE");
  app.add_option("--csv", choice->csv, "folder for channels.csv")->type_name("DIR");
  app.add_option("--json", choice->json, "folder for summary, metrics and scenario as JSON")->type_name("DIR");
  app.add_option("--vtp", choice->vtp, "folder for a series that ParaView opens")->type_name("DIR");
  app.add_option("--vtkhdf", choice->vtkhdf, "folder for the same as files with time steps")->type_name("DIR");
  app.add_option("--gltf", choice->gltf, "animation of the whole capture (.glb)")->type_name("FILE");
  app.add_option("--keys", choice->keys, "most moments of the animation")
      ->type_name("N")
      ->check(whole_number(2, 100000))
      ->capture_default_str();
  app.add_flag("--quiet", choice->quiet, "no progress");
  app.footer(kExportHelp +
             exit_code_help({ExitCode::bad_input, ExitCode::io, ExitCode::rendering, ExitCode::interrupted}));
  return [choice](const std::string&) { return export_recording(*choice); };
}

}  // namespace netpocket
