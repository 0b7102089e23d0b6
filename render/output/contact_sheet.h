#pragma once
// Several pictures as one, like a figure in a paper: a grid with captions on white.

#include <string>
#include <vector>

#include "render/output/image.h"

namespace netpocket {

struct SheetPanel {
  Image image;
  std::string caption;  // centred below the picture; may have several lines
};

struct SheetLayout {
  int columns = 3;
  int margin = 24;                         // pixels, around and between panels
  int caption_size = 26;                   // pixels, height of the letters' line; 0: no captions
  std::vector<std::string> headings = {};  // above the columns
};

// Columns for panels of an aspect (width / height): the last row is full or lacks little, the sheet about as broad as a
// screen.
int balanced_columns(int panels, double aspect);

// Cells are as large as the largest panel; a last row that is not full starts at the left. Throws RenderError when
// there is no panel or no column.
Image make_contact_sheet(const std::vector<SheetPanel>& panels, const SheetLayout& layout = {});

}  // namespace netpocket
