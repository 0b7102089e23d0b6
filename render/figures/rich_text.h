#pragma once
// Text with the little markup that axis titles need: *italic*, _{subscript}, ^{superscript}; a backslash takes the next
// character as it is. UTF-8, DejaVu Sans. No hinting, so text has the same measures in every output.

#include <cairo.h>

#include <string>
#include <string_view>
#include <vector>

#include "render/figures/palette.h"

namespace netpocket {

struct TextStyle {
  double size = 8;  // points
  bool bold = false;
  FigureColour colour = kBlack;
};

enum class TextAlign { left, centre, right };

// Heights of DejaVu Sans as fractions of the size.
inline constexpr double kCapHeight = 0.729;
inline constexpr double kLineHeight = 1.25;

// A stretch of text in one face.
struct TextRun {
  std::string text;
  bool italic = false;
  int script = 0;  // -1 subscript, 0 normal, +1 superscript

  bool operator==(const TextRun&) const = default;
};

std::vector<TextRun> parse_rich_text(std::string_view markup);

// Of a run of a text, points: the size of its letters, and how far its baseline is below the text's.
double font_size(const TextRun& run, const TextStyle& style);
double baseline_shift(const TextRun& run, const TextStyle& style);

// Escapes the markup, so that the text appears as it is.
std::string plain_text(std::string_view text);

double text_width(cairo_t* context, std::string_view markup, const TextStyle& style);

// The style, smaller if need be for the text to keep within `width`.
TextStyle shrunk_to_fit(cairo_t* context, std::string_view markup, TextStyle style, double width);

// y is the baseline; x the left end, the centre or the right end.
void draw_text(cairo_t* context, std::string_view markup, const TextStyle& style, double x, double y, TextAlign align);

// Reads upwards, centred on y; x is the baseline.
void draw_upward_text(cairo_t* context, std::string_view markup, const TextStyle& style, double x, double y);

}  // namespace netpocket
