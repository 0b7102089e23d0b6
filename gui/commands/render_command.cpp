#include <fmt/format.h>

#include <memory>

#include "gui/commands/command.h"
#include "gui/commands/interrupt.h"
#include "gui/commands/options.h"
#include "gui/commands/progress_line.h"
#include "gui/commands/recordings.h"
#include "render/output/render_frames.h"
#include "render/output/render_sheet.h"

namespace netpocket {
namespace {

constexpr const char* kExamples =
    R"(Needs no display. Without --times, --fps or --every: 25 pictures a second, and six panels on a sheet.

Examples:
  netpocket render case1.h5 -o frames --fps 25 --video case1.mp4
  netpocket render case1.h5 --times 0,2.5,5,7.5,10,15 --sheet sheet.png
  netpocket render case1.h5 -o frames --times 10 --camera mouth --color-by tension --size 3840x2160

)";

constexpr double kDefaultRate = 25;  // pictures per second
constexpr int kDefaultPanels = 6;

struct RenderChoice {
  std::string recording;
  std::string folder, sheet, video;
  std::vector<double> times;
  double rate = kDefaultRate;
  int every = 0;  // 0: not given
  PictureSize size{1280, 720};
  PictureSize panel_size{800, 640};
  int columns = 3;
  int supersampling = 2;
  std::string camera = "iso", color_by = "none", background = "white", backend = "auto", title;
  bool quiet = false;
};

void apply_look(const RenderChoice& choice, RunView& view) {
  view.camera = camera_from_name(choice.camera);
  view.backend = gl_backend_from_name(choice.backend);
  view.frame.scene.color_by = color_by_from_name(choice.color_by);
  view.frame.scene.background = background_from_name(choice.background);
  view.frame.scene.title = choice.title;
}

RenderOptions render_options(const RenderChoice& choice) {
  RenderOptions options;
  apply_look(choice, options.view);
  options.view.frame.width = choice.size.width;
  options.view.frame.height = choice.size.height;
  options.view.frame.supersampling = choice.supersampling;
  options.folder = choice.folder;
  options.video = choice.video;
  options.video_rate = choice.rate;
  return options;
}

SheetOptions sheet_options(const RenderChoice& choice) {
  SheetOptions options;
  apply_look(choice, options.view);
  options.view.frame.width = choice.panel_size.width;
  options.view.frame.height = choice.panel_size.height;
  options.layout.columns = choice.columns;
  return options;
}

// Refuses times that the recording does not reach: the nearest frame would not be what was asked for.
void check_times(const Recording& recording, const std::vector<double>& times) {
  if (recording.frame_count() == 0) return;
  const double first = recording.times().front(), last = recording.times().back();
  constexpr double kTolerance = 1e-6;  // s
  for (const double time : times) {
    if (time >= first - kTolerance && time <= last + kTolerance) continue;
    throw CommandError(ExitCode::usage,
                       fmt::format("--times: {:g} s is outside the recording, {:g} s to {:g} s", time, first, last));
  }
}

std::vector<double> picture_times(const Recording& recording, const RenderChoice& choice) {
  if (!choice.times.empty()) return choice.times;
  if (choice.every == 0) return frame_times(recording, choice.rate);
  std::vector<double> times;
  for (std::size_t i = 0; i < recording.frame_count(); i += static_cast<std::size_t>(choice.every)) {
    times.push_back(recording.times()[i]);
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

void render_pictures(const Recording& recording, const RenderChoice& choice, const std::stop_token& stop) {
  ProgressLine line(!choice.quiet);
  const auto show = [&](const RenderProgress& p) {
    line.update(static_cast<double>(p.done) / static_cast<double>(p.total),
                fmt::format("picture {} of {}, {} left", p.done, p.total, duration_text(p.seconds_left)));
  };
  render_frames(recording, picture_times(recording, choice), render_options(choice), show, stop);
}

ExitCode render(const RenderChoice& choice) {
  if (choice.folder.empty() && choice.sheet.empty() && choice.video.empty()) {
    throw CommandError(ExitCode::usage, "nothing to write: give --output, --sheet or --video");
  }
  const Recording recording = open_recording(choice.recording);
  check_times(recording, choice.times);
  if (!choice.folder.empty()) make_output_folder(choice.folder);
  for (const std::string& file : {choice.sheet, choice.video}) {
    if (!file.empty()) require_writable(file);
  }
  const Interrupt interrupt;
  const std::stop_token stop = interrupt.token();
  if (!choice.folder.empty() || !choice.video.empty()) render_pictures(recording, choice, stop);
  if (!choice.sheet.empty()) {
    render_sheet(recording, panel_times(recording, choice), choice.sheet, sheet_options(choice), stop);
  }
  return stop.stop_requested() ? ExitCode::interrupted : ExitCode::ok;
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
}

void add_times(CLI::App& app, RenderChoice& choice) {
  const char* const group = "Which moments (at most one)";
  CLI::Option* times = app.add_option("--times", choice.times, "simulated times, s, such as 0,2.5,5")
                           ->type_name("T")
                           ->delimiter(',')
                           ->allow_extra_args(false)
                           ->check(number_not_below_zero())
                           ->group(group);
  CLI::Option* rate = app.add_option("--fps", choice.rate, "pictures per simulated second, and per second of the video")
                          ->type_name("N")
                          ->check(positive_number())
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
         "of pictures and video, pixels (default: 1280x720)")
      ->type_name("WxH")
      ->check(is_picture_size());
  app.add_option_function<std::string>(
         "--panel-size", [&choice](const std::string& text) { choice.panel_size = *picture_size(text); },
         "of a sheet's panels, pixels (default: 800x640)")
      ->type_name("WxH")
      ->check(is_picture_size());
  app.add_option("--columns", choice.columns, "panels side by side on a sheet")
      ->type_name("N")
      ->check(whole_number(1, 100))
      ->capture_default_str();
  app.add_option("--supersampling", choice.supersampling, "1: jagged and fastest, to 4: smoothest pictures")
      ->type_name("N")
      ->check(whole_number(1, 4))
      ->capture_default_str();
  add_choice(app, "--camera", choice.camera, "where from", {"iso", "side", "front", "mouth", "follow"});
  add_choice(app, "--color-by", choice.color_by, "colour of cords and rods", {"none", "tension", "strain", "speed"});
  add_choice(app, "--background", choice.background, "behind the scene", {"white", "space"});
  add_choice(app, "--backend", choice.backend, "OpenGL without a display", {"auto", "osmesa", "egl"});
  app.add_option("--title", choice.title, "above each picture")->type_name("TEXT");
}

}  // namespace

Action declare_render(CLI::App& app) {
  const auto choice = std::make_shared<RenderChoice>();
  app.add_option("RUN.h5", choice->recording, "recording to draw")->required()->type_name("FILE");
  add_outputs(app, *choice);
  add_times(app, *choice);
  add_look(app, *choice);
  app.add_flag("--quiet", choice->quiet, "no progress");
  app.footer(kExamples +
             exit_code_help({ExitCode::bad_input, ExitCode::io, ExitCode::rendering, ExitCode::interrupted}));
  return [choice](const std::string&) { return render(*choice); };
}

}  // namespace netpocket
