#pragma once
// A contact sheet of a recorded run.

#include <optional>
#include <string>
#include <vector>

#include "render/output/contact_sheet.h"
#include "render/output/render_frames.h"

namespace netpocket {

struct SheetOptions {
  // Size, camera and scene of a panel. Axes, scale bar and legend stand in the first panel only; the captions give the
  // times.
  RunView view = panel_view();
  SheetLayout layout;          // its columns do not matter
  std::optional<int> columns;  // absent: so that the last row is full or nearly so

  static RunView panel_view();  // 640 x 640 pixels
};

// A picture with a panel for each time, as render_sheet() writes it; nothing when it was stopped.
std::optional<Image> draw_sheet(const std::vector<const Recording*>& recordings, const std::vector<double>& times,
                                const SheetOptions& options = {}, const std::stop_token& stop = {});

// Writes a PNG with a panel "(a) t = 2.5 s, closing" for each time (s). Errors and thread contract as render_frames.
void render_sheet(const Recording& recording, const std::vector<double>& times, const std::string& path,
                  const SheetOptions& options = {}, const std::stop_token& stop = {});

// Several runs next to each other: a column for each run with its name, a row for each time; the options'
// columns do not matter. Framed and coloured alike. A run that has no frame at a time shows the nearest it has.
void render_sheet(const std::vector<const Recording*>& recordings, const std::vector<double>& times,
                  const std::string& path, const SheetOptions& options = {}, const std::stop_token& stop = {});

}  // namespace netpocket
