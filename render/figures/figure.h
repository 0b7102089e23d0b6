#pragma once
// A figure as a plain value: panels in a grid, each with axes, curves and phase bands, at a printed size. Drawing does
// not change it, so the same figure can go to a file, a window and a test.
//
// Texts are rich text (rich_text.h): *italic*, _{subscript}, ^{superscript}. Pass names that come from a user through
// plain_text(). Lengths on paper are in points (1/72 inch) unless the name says millimetres.

#include <cairo.h>

#include <optional>
#include <string>
#include <vector>

#include "render/figures/axis_ticks.h"
#include "render/figures/palette.h"
#include "render/figures/polyline.h"

namespace netpocket {

enum class Marker { none, circle };

// A line through (x[i], y[i]) in data units. A value that is not finite leaves a gap.
struct Curve {
  std::vector<double> x;
  std::vector<double> y;
  FigureColour colour = kBlack;
  double width = 0.9;            // points
  std::vector<double> dash;      // on, off, ... in points; empty: solid
  Marker marker = Marker::none;  // drawn at every point, instead of a line when there is only one
  std::string label;             // legend entry; empty: none
  std::string name;              // of what it shows, in tables, without markup; empty: the label
};

// A stretch of the x axis with a light tint, a label at the top and a dashed line where it begins.
struct PhaseBand {
  double begin = 0;
  double end = 0;
  std::string label;
  FigureColour colour;
};

// A name at a place of an axis.
struct NamedTick {
  double value = 0;
  std::string name;
};

// One axis. Unless given, its limits follow from the curves: tight in x, with a margin in y.
struct PanelAxis {
  std::string title;        // quantity and unit, e.g. "Time (s)"
  double minimum_span = 0;  // shows smaller variations, such as round-off, as the flat line they are
  std::optional<AxisLimits> limits;
  std::vector<NamedTick> names;  // instead of numbers
  bool whole_numbers = false;    // of a count, such as generations: no ticks between them
};

// Says `empty`, when no point of its curves is finite.
struct Panel {
  std::string title;
  PanelAxis x;
  PanelAxis y;
  std::vector<Curve> curves;      // drawn in this order
  std::vector<PhaseBand> phases;  // from left to right
  int y_group = -1;               // panels of one group (>= 0) share their y limits
  std::string empty = "no data";
};

struct Figure {
  std::string title;
  std::vector<Panel> panels;  // row by row
  int columns = 1;
  double width_mm = 180;  // a journal's two-column width
  double height_mm = 70;
  std::string note{};  // in small letters below the panels, broken into lines; e.g. that it shows a draft

  double width() const { return width_mm * 72 / 25.4; }    // points
  double height() const { return height_mm * 72 / 25.4; }  // points
};

// Where a panel was drawn: its frame in the context's user space, and what the frame's edges stand for.
struct PanelFrame {
  PlotBox box;
  AxisLimits x;
  AxisLimits y;
};

// Draws the figure on a white ground into the rectangle (0, 0, width, height) of the context's user space, whose unit
// is taken as one point: text keeps its size, the panels fill what is left. For a screen, cairo_scale() first. The
// context's state is restored. Works on any Cairo surface; on image surfaces long curves are reduced to what the pixels
// can show. Returns the frames of the panels, for cursors. Thread contract: one thread at a time per context.
std::vector<PanelFrame> draw_figure(const Figure& figure, cairo_t* context, double width, double height);

}  // namespace netpocket
