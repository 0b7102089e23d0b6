#pragma once
// Pictures of captures of a study, which are run again for them: a study keeps no recordings.
// Thread contract: any one thread.

#include <stop_token>
#include <string>
#include <vector>

#include "engine/study/worst_captures.h"
#include "render/gl/gl_host.h"
#include "render/output/image.h"
#include "render/output/render_progress.h"

namespace netpocket {

struct CapturePictureOptions {
  int size = 480;  // pixels, width and height of a picture
  GlBackend backend = GlBackend::automatic;
};

// The captures of these rows as they are at their ends, each framed by itself; empty when it was stopped. The runs are
// those of the records, to the last bit if the same version of the program makes them. Throws FileError when the folder
// does not say enough, or when a scenario or mesh has changed since, and RenderError.
std::vector<Image> draw_captures(const std::string& folder, const StudyResults& results,
                                 const std::vector<std::size_t>& rows, const CapturePictureOptions& options = {},
                                 const RenderProgressCallback& progress = {}, const std::stop_token& stop = {});

struct CaptureSheetOptions {
  CaptureRanking ranking;
  std::size_t worst = 12, typical = 4;
  int columns = 4;
  CapturePictureOptions picture;
};

// A sheet of the worst captures, worst first, and of typical ones, with number, outcome, the ranked value and the
// inputs that decide most. Writes a PNG; nothing when it was stopped. Throws RenderError when no capture has a value of
// the column, and as draw_captures().
RenderOutcome write_capture_sheet(const std::string& folder, const StudyResults& results, const std::string& path,
                                  const CaptureSheetOptions& options = {}, const RenderProgressCallback& progress = {},
                                  const std::stop_token& stop = {});

}  // namespace netpocket
