#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <set>

#include "engine/analysis/run_labels.h"
#include "engine/base/folder.h"
#include "engine/base/output_list.h"
#include "engine/base/whole_file.h"
#include "gui/commands/command.h"
#include "gui/commands/interrupt.h"
#include "gui/commands/notes.h"
#include "gui/commands/options.h"
#include "gui/commands/progress_line.h"
#include "gui/commands/recordings.h"
#include "gui/commands/standard_streams.h"
#include "render/output/render_frames.h"
#include "render/output/render_sheet.h"
#include "render/output/write_gltf.h"
#include "render/render_error.h"
#include "render/scene/view_file.h"

namespace netpocket {
namespace {

constexpr const char* kRenderExamples =
    R"(Needs no display. Without --times, --fps or --every: 25 pictures a second, and six panels on a sheet. Several
recordings are drawn next to each other at equal times. A view file holds position, focal_point (m), and view_angle
(degrees) or half_height (m); --save-view writes one to start from.

Examples:
  netpocket render case1.h5 -o frames --fps 25 --video case1.mp4
  netpocket render case1.h5 --times 0,2.5,5,7.5,10,15 --sheet sheet.png
  netpocket render case1.h5 -o frames --times 10 --camera mouth --color-by tension --size 3840x2160
  netpocket render case1.h5 --times 6 -o frames --arrows --ghost --trails --target-opacity 0.4
  netpocket render case1.h5 case2.h5 case3.h5 --video side_by_side.mp4
  netpocket render case1.h5 --times 10 --gltf closed.glb

)";

constexpr double kDefaultRate = 25;  // pictures per second
constexpr int kDefaultPanels = 6;

struct RenderChoice {
  std::vector<std::string> recordings;
  std::string folder, sheet, video, gltf, saved_view;
  std::vector<double> times;
  double rate = kDefaultRate;
  int every = 0;       // 0: not given
  PictureSize size{};  // 0: not given
  PictureSize panel_size{640, 640};
  std::optional<int> columns;
  int supersampling = 2;
  std::string camera = "iso", color_by = "none", background = "white", backend = "auto", view_file;
  std::vector<double> color_range;
  double arrow_force = 0;  // 0: not given
  DisplayOptions display;
  bool transparent = false;
  bool resume = false;
  bool quiet = false;
};

CameraView load_view(const std::string& path) {
  require_readable(path);
  try {
    return read_view_file(path);
  } catch (const RenderError& error) {
    throw CommandError(ExitCode::bad_input, error.what());
  }
}

void apply_look(const RenderChoice& choice, RunView& view) {
  auto& scene = view.frame.scene;
  static_cast<DisplayOptions&>(scene) = choice.display;
  scene.color_by = color_by_from_name(choice.color_by);
  scene.background = background_from_name(choice.background);
  if (!choice.color_range.empty()) scene.color_range = ValueRange{choice.color_range[0], choice.color_range[1]};
  if (choice.arrow_force > 0) scene.arrow_force = choice.arrow_force;
  view.camera = camera_from_name(choice.camera);
  view.backend = gl_backend_from_name(choice.backend);
  if (!choice.view_file.empty()) view.view = load_view(choice.view_file);
}

// Several runs share the width that one has by default and half as much again.
PictureSize picture_size_of(const RenderChoice& choice) {
  if (choice.size.width > 0) return choice.size;
  return choice.recordings.size() == 1 ? PictureSize{1280, 720} : PictureSize{640, 640};
}

RenderOptions render_options(const RenderChoice& choice) {
  RenderOptions options;
  apply_look(choice, options.view);
  const PictureSize size = picture_size_of(choice);
  options.view.frame.width = size.width;
  options.view.frame.height = size.height;
  options.view.frame.supersampling = choice.supersampling;
  options.view.frame.scene.transparent_background = choice.transparent;
  options.folder = choice.folder;
  options.video = choice.video;
  options.video_rate = choice.rate;
  options.resume = choice.resume;
  return options;
}

SceneOptions gltf_options(const RenderChoice& choice) {
  RunView view;
  apply_look(choice, view);
  return view.frame.scene;
}

SheetOptions sheet_options(const RenderChoice& choice) {
  SheetOptions options;
  const bool time_label = options.view.frame.scene.time_label;
  apply_look(choice, options.view);
  options.view.frame.scene.time_label = time_label;
  options.view.frame.width = choice.panel_size.width;
  options.view.frame.height = choice.panel_size.height;
  options.columns = choice.columns;
  return options;
}

using Recordings = std::vector<const Recording*>;

// Refuses times that a recording does not reach: the nearest frame would not be what was asked for.
void check_times(const Recording& recording, const std::vector<double>& times) {
  if (recording.frame_count() == 0) return;
  const double first = recording.times().front(), last = recording.times().back();
  constexpr double kTolerance = 1e-6;  // s
  for (const double time : times) {
    if (time >= first - kTolerance && time <= last + kTolerance) continue;
    throw CommandError(ExitCode::usage, fmt::format("--times: {:g} s is outside the recording \"{}\", {:g} s to {:g} s",
                                                    time, recording.path(), first, last));
  }
}

std::vector<double> picture_times(const Recordings& recordings, const RenderChoice& choice) {
  if (!choice.times.empty()) return choice.times;
  if (choice.every == 0) {
    require_fewer_pictures(recordings, choice.rate);
    return frame_times(recordings, choice.rate);
  }
  std::vector<double> times;
  const auto& recorded = recordings.front()->times();
  for (std::size_t i = 0; i < recorded.size(); i += static_cast<std::size_t>(choice.every)) {
    times.push_back(recorded[i]);
  }
  return times;
}

std::vector<double> panel_times(const Recording& recording, const RenderChoice& choice) {
  if (!choice.times.empty() || recording.frame_count() == 0) return choice.times;
  const double first = recording.times().front(), last = recording.times().back();
  std::vector<double> times;
  for (int i = 0; i < kDefaultPanels; ++i) times.push_back(first + (last - first) * i / (kDefaultPanels - 1));
  return times;
}

void render_pictures(const Recordings& recordings, const RenderChoice& choice, const std::stop_token& stop) {
  ProgressLine line(!choice.quiet);
  const auto show = [&](const RenderProgress& p) {
    line.update(static_cast<double>(p.done) / static_cast<double>(p.total),
                fmt::format("picture {} of {}, {} left", p.done, p.total, duration_text(p.seconds_left)));
  };
  const std::vector<double> times = picture_times(recordings, choice);
  if (render_frames(recordings, times, render_options(choice), show, stop) == RenderOutcome::cancelled) return;
  if (choice.folder.empty()) return;
  std::set<std::string> pictures;
  for (std::size_t i = 0; i < times.size(); ++i) pictures.insert(picture_file_name(i, times.size()));
  note_older_files(choice.folder, "", ".png", pictures);
}

void save_view(const Recordings& recordings, const RenderChoice& choice) {
  const auto view = common_view(recordings, render_options(choice).view).view;
  if (!view) throw CommandError(ExitCode::usage, "--save-view: the camera \"follow\" is not one view");
  write_whole_file(choice.saved_view, FileKind::view, view_text(*view));
}

// Combinations of options that contradict each other.
void check_choice(const RenderChoice& choice) {
  const bool pictures = !choice.folder.empty() || !choice.video.empty();
  if (!pictures && choice.sheet.empty() && choice.gltf.empty() && choice.saved_view.empty()) {
    throw CommandError(ExitCode::usage, "nothing to write: give --output, --sheet, --video, --gltf or --save-view");
  }
  if (choice.transparent && (choice.folder.empty() || !choice.video.empty())) {
    throw CommandError(ExitCode::usage,
                       "--transparent is for pictures (--output); videos and sheets have a background");
  }
  if (choice.resume && choice.folder.empty()) {
    throw CommandError(ExitCode::usage, "--resume needs --output: the pictures that exist are what it goes on from");
  }
  if (!choice.gltf.empty() && (choice.times.size() != 1 || choice.recordings.size() != 1)) {
    throw CommandError(ExitCode::usage, "--gltf needs one recording and one time, such as --times 10");
  }
}

// "0123.png": as the pictures in a folder are called.
bool is_picture_name(const std::string& name) {
  const std::size_t digits = std::min(name.find_first_not_of("0123456789"), name.size());
  return digits > 0 && name.substr(digits) == suffix(FileKind::png);
}

void check_outputs(const RenderChoice& choice) {
  OutputList outputs;
  for (const std::string& recording : choice.recordings) outputs.add_input(recording);
  if (!choice.view_file.empty()) outputs.add_input(choice.view_file);
  if (!choice.folder.empty()) {
    make_folder(choice.folder);
    outputs.add_folder("--output", choice.folder, is_picture_name);
  }
  if (!choice.sheet.empty()) outputs.add("--sheet", choice.sheet, FileKind::png);
  if (!choice.video.empty()) outputs.add("--video", choice.video, FileKind::video);
  if (!choice.gltf.empty()) outputs.add("--gltf", choice.gltf, FileKind::gltf);
  if (!choice.saved_view.empty()) outputs.add("--save-view", choice.saved_view, FileKind::view);
}

ExitCode render(const RenderChoice& choice) {
  check_choice(choice);
  const std::vector<Recording> opened = open_recordings(choice.recordings);
  const Recordings recordings = pointers(opened);
  for (const auto* recording : recordings) check_times(*recording, choice.times);
  check_outputs(choice);
  note_missing_letters(recordings.size() > 1 ? run_labels(recordings) : std::vector<std::string>{},
                       choice.display.title);
  const Interrupt interrupt;
  const std::stop_token stop = interrupt.token();
  if (!choice.saved_view.empty()) save_view(recordings, choice);
  if (!choice.gltf.empty()) write_gltf(*recordings.front(), choice.times.front(), choice.gltf, gltf_options(choice));
  if (!choice.folder.empty() || !choice.video.empty()) render_pictures(recordings, choice, stop);
  if (!choice.sheet.empty()) {
    render_sheet(recordings, panel_times(*recordings.front(), choice), choice.sheet, sheet_options(choice), stop);
  }
  if (!stop.stop_requested()) return ExitCode::ok;
  say("interrupted; what was finished so far is kept");
  return ExitCode::interrupted;
}

void add_outputs(CLI::App& app, RenderChoice& choice) {
  const char* const group = "What to write (at least one)";
  app.add_option("-o,--output", choice.folder, "folder for pictures: 0000.png, 0001.png, ...")
      ->type_name("DIR")
      ->group(group);
  app.add_option("--sheet", choice.sheet, "one picture with a labelled panel for each time")
      ->type_name("FILE.png")
      ->group(group);
  app.add_option("--video", choice.video, "video of the pictures (needs ffmpeg)")->type_name("FILE.mp4")->group(group);
  app.add_option("--gltf", choice.gltf, "one moment in three dimensions, for Blender or a browser (binary glTF)")
      ->type_name("FILE.glb")
      ->group(group);
  app.add_option("--save-view", choice.saved_view, "the view as a file for --view")
      ->type_name("FILE.toml")
      ->group(group);
}

void add_times(CLI::App& app, RenderChoice& choice) {
  const char* const group = "Which moments (at most one)";
  const auto add = [&choice](const std::string& list) {
    for (const double time : numbers_of(list)) choice.times.push_back(time);
  };
  CLI::Option* times =
      app.add_option_function<std::vector<std::string>>(
             "--times", [add](const std::vector<std::string>& lists) { std::ranges::for_each(lists, add); },
             "simulated times, s, such as 0,2.5,5")
          ->type_name("T")
          ->allow_extra_args(false)
          ->check(list_of_times())
          ->group(group);
  CLI::Option* rate = app.add_option("--fps", choice.rate, "pictures per simulated second, and per second of the video")
                          ->type_name("N")
                          ->check(number_between(kLowestRate, kHighestRate))
                          ->group(group);
  CLI::Option* every = app.add_option("--every", choice.every, "every Nth recorded frame")
                           ->type_name("N")
                           ->check(whole_number(1, 1000000))
                           ->group(group);
  times->excludes(rate)->excludes(every);
  rate->excludes(every);
}

void add_look(CLI::App& app, RenderChoice& choice) {
  app.add_option_function<std::string>(
         "--size", [&choice](const std::string& text) { choice.size = *picture_size(text); },
         "of pictures and video, for each recording, pixels (default: 1280x720; of several: 640x640)")
      ->type_name("WxH")
      ->check(is_picture_size());
  app.add_option_function<std::string>(
         "--panel-size", [&choice](const std::string& text) { choice.panel_size = *picture_size(text); },
         "of a sheet's panels, pixels (default: 640x640)")
      ->type_name("WxH")
      ->check(is_picture_size());
  app.add_option("--columns", choice.columns, "panels side by side on a sheet (default: so that the last row is full)")
      ->type_name("N")
      ->check(whole_number(1, 100));
  app.add_option("--supersampling", choice.supersampling, "1: jagged and fastest, to 4: smoothest pictures")
      ->type_name("N")
      ->check(whole_number(1, 4))
      ->capture_default_str();
  add_choice(app, "--camera", choice.camera, "where from", {"iso", "side", "front", "mouth", "follow"});
  app.add_option("--view", choice.view_file, "where from, by a view file; instead of --camera")
      ->type_name("FILE.toml")
      ->excludes(app.get_option("--camera"));
  add_choice(app, "--color-by", choice.color_by, "colour of cords and rods",
             {"none", "tension", "strain", "speed", "contact"});
  app.add_option_function<std::string>(
         "--color-range", [&choice](const std::string& text) { choice.color_range = numbers_of(text); },
         "values at the ends of the colours, SI units (default: by the run)")
      ->type_name("LOW,HIGH")
      ->check(range_of_numbers());
  add_choice(app, "--background", choice.background, "behind the scene", {"white", "space"});
  add_choice(app, "--backend", choice.backend, "OpenGL without a display", {"auto", "osmesa", "egl"});
  app.add_flag("--transparent", choice.transparent, "pictures without a background");
  app.add_option("--title", choice.display.title, "above each picture")->type_name("TEXT");
}

void add_extras(CLI::App& app, RenderChoice& choice) {
  const char* const group = "What else to show";
  app.add_flag("--arrows", choice.display.contact_arrows, "forces of contacts as arrows")->group(group);
  app.add_option("--arrow-force", choice.arrow_force, "force of the longest arrow, N (default: by the run)")
      ->type_name("N")
      ->check(positive_number())
      ->group(group);
  app.add_flag("--trails", choice.display.trails, "paths of the centres of mass")->group(group);
  app.add_flag("--ghost", choice.display.ghost, "the pocket's initial shape")->group(group);
  app.add_option("--target-opacity", choice.display.target_opacity, "0: not seen, 1: solid")
      ->type_name("N")
      ->check(number_between(0, 1))
      ->group(group);
}

}  // namespace

Action declare_render(CLI::App& app) {
  const auto choice = std::make_shared<RenderChoice>();
  app.add_option("RUN.h5", choice->recordings, "recordings to draw, next to each other")->required()->type_name("FILE");
  add_outputs(app, *choice);
  add_times(app, *choice);
  add_look(app, *choice);
  add_extras(app, *choice);
  app.add_flag("--resume", choice->resume, "keep the pictures in the folder that would come out the same");
  app.add_flag("--quiet", choice->quiet, "no progress");
  app.footer(kRenderExamples +
             exit_code_help({ExitCode::bad_input, ExitCode::io, ExitCode::rendering, ExitCode::interrupted}));
  return [choice](const std::string&) { return render(*choice); };
}

}  // namespace netpocket
