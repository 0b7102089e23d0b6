#pragma once
// A run, or several next to each other, as one HTML file that opens without a network: what they came to, the capture
// as a sheet and a video, the paper's findings and figures, and the scenarios.

#include <stop_token>
#include <string>
#include <vector>

#include "engine/recording/recording.h"
#include "render/gl/gl_host.h"
#include "render/output/render_progress.h"

namespace netpocket {

struct ReportOptions {
  GlBackend backend = GlBackend::automatic;
  bool video = true;         // needs ffmpeg
  double video_rate = 12.5;  // pictures per simulated second
};

// Progress counts the video's pictures. Thread contract: any one thread. Errors: RenderError, FigureError or
// FileError with one sentence. When it fails or is stopped there is no file, or the older one.
RenderOutcome write_report(const std::vector<const Recording*>& recordings, const std::string& path,
                           const ReportOptions& options = {}, const RenderProgressCallback& progress = {},
                           const std::stop_token& stop = {});

}  // namespace netpocket
