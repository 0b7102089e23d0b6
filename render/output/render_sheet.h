#pragma once
// A contact sheet of a recorded run.

#include <string>
#include <vector>

#include "render/output/contact_sheet.h"
#include "render/output/render_frames.h"

namespace netpocket {

struct SheetOptions {
  // Size, camera and scene of a panel. Axes, scale bar and legend stand in the first panel only; the captions give the
  // times.
  RunView view = panel_view();
  SheetLayout layout;

  static RunView panel_view();  // 800 x 640 pixels
};

// Writes a PNG with a panel "(a) t = 2.5 s, closing" for each time (s). Errors and thread contract as render_frames.
void render_sheet(const Recording& recording, const std::vector<double>& times, const std::string& path,
                  const SheetOptions& options = {}, const std::stop_token& stop = {});

}  // namespace netpocket
