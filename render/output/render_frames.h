#pragma once
// Pictures, a video and a contact sheet of a recorded run: what `netpocket render` and the workbench call.
// Thread contract: any one thread; progress is reported on it. Memory does not grow with the number of frames.
// Errors: RenderError or FileError with one sentence. Whatever happens, only whole files are left.

#include <stop_token>
#include <string>
#include <vector>

#include "render/output/render_progress.h"
#include "render/output/run_renderer.h"

namespace netpocket {

struct RenderOptions {
  RunView view;                        // of each run
  std::string folder;                  // of 0000.png, 0001.png, ...; made if need be; empty: no pictures
  std::string video;                   // an .mp4 file; empty: none
  std::string* video_bytes = nullptr;  // gets the video instead, as a part of the HTML page that `video` names
  double video_rate = 25;              // frames per second of the video
  bool resume = false;                 // keep pictures in the folder that are of the same run, time and look
};

// One picture for each time (s), of the recorded frame nearest to it. When stopped, the pictures finished so far stay,
// the video does not.
RenderOutcome render_frames(const Recording& recording, const std::vector<double>& times, const RenderOptions& options,
                            const RenderProgressCallback& progress = {}, const std::stop_token& stop = {});

// Several runs in one picture, next to each other from left to right, framed and coloured alike, each with its name in
// the title. A run that has no frame at a time shows the nearest it has. Pictures are as many times wider than the
// view.
RenderOutcome render_frames(const std::vector<const Recording*>& recordings, const std::vector<double>& times,
                            const RenderOptions& options, const RenderProgressCallback& progress = {},
                            const std::stop_token& stop = {});

// The name of a picture in its folder.
std::string picture_file_name(std::size_t index, std::size_t total);

// Times from the start to the end of a recording, `rate` a simulated second. Throws RenderError unless the rate is
// positive.
std::vector<double> frame_times(const Recording& recording, double rate);
// From the first start to the last end of several.
std::vector<double> frame_times(const std::vector<const Recording*>& recordings, double rate);

}  // namespace netpocket
