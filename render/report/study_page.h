#pragma once
// A study as one HTML file that opens without a network: the probability of capture, a map of the captures that answers
// to the mouse and the keys, figures, and pictures of the worst and of typical captures.

#include <stop_token>
#include <string>

#include "render/report/capture_pictures.h"

namespace netpocket {

struct StudyReportOptions {
  CaptureRanking ranking;  // which captures are drawn
  std::size_t worst = 12, typical = 4;
  CapturePictureOptions picture;
};

// Progress counts the pictures, for each of which a capture is run again. Errors: as draw_captures(), and FigureError.
// When it fails or is stopped there is no file, or the older one. Thread contract: any one thread.
RenderOutcome write_study_report(const std::string& folder, const std::string& path,
                                 const StudyReportOptions& options = {}, const RenderProgressCallback& progress = {},
                                 const std::stop_token& stop = {});

// The page, from what it holds: pictures (PNG) by row of the results, in the order in which they are shown, and figures
// (SVG) by name. `drafts`: a sentence about those of the results that are drafts (study/draft_runs.h).
std::string study_page(const std::string& name, const StudyResults& results,
                       const std::vector<std::pair<std::size_t, std::string>>& pictures,
                       const std::vector<std::pair<std::string, std::string>>& figures, const std::string& drafts = "");

}  // namespace netpocket
