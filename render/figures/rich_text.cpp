#include "render/figures/rich_text.h"

#include <algorithm>

#include "render/figures/svg_text.h"
#include "render/fonts/cairo_font.h"
#include "render/fonts/drawable_text.h"

namespace netpocket {
namespace {

constexpr double kScriptSize = 0.7;
constexpr double kSuperscriptRise = 0.38;
constexpr double kSubscriptDrop = 0.16;

// Chooses the run's font; returns what to draw with it.
std::string select_face(cairo_t* context, const TextRun& run, const TextStyle& style) {
  DrawableText drawable = drawable_text(run.text, {.bold = style.bold, .italic = run.italic});
  use_cairo_font(context, drawable.font, font_size(run, style), false);
  return std::move(drawable.text);
}

double advance(cairo_t* context, const std::string& text) {
  cairo_text_extents_t extents;
  cairo_text_extents(context, text.c_str(), &extents);
  return extents.x_advance;
}

}  // namespace

double font_size(const TextRun& run, const TextStyle& style) {
  return run.script == 0 ? style.size : kScriptSize * style.size;
}

double baseline_shift(const TextRun& run, const TextStyle& style) {
  if (run.script > 0) return -kSuperscriptRise * style.size;
  if (run.script < 0) return kSubscriptDrop * style.size;
  return 0;
}

std::vector<TextRun> parse_rich_text(std::string_view markup) {
  std::vector<TextRun> runs;
  TextRun current;
  const auto start_run = [&](bool italic, int script) {
    if (!current.text.empty()) runs.push_back(current);
    current = {"", italic, script};
  };
  for (std::size_t i = 0; i < markup.size(); ++i) {
    const char c = markup[i];
    const bool opens_script = (c == '_' || c == '^') && i + 1 < markup.size() && markup[i + 1] == '{';
    if (c == '\\' && i + 1 < markup.size()) {
      current.text += markup[++i];
    } else if (c == '*') {
      start_run(!current.italic, current.script);
    } else if (opens_script) {
      start_run(current.italic, c == '_' ? -1 : +1);
      ++i;
    } else if (c == '}' && current.script != 0) {
      start_run(current.italic, 0);
    } else {
      current.text += c;
    }
  }
  start_run(false, 0);
  return runs;
}

std::string plain_text(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '*' || c == '_' || c == '^' || c == '\\') escaped += '\\';
    escaped += c;
  }
  return escaped;
}

double text_width(cairo_t* context, std::string_view markup, const TextStyle& style) {
  double width = 0;
  for (const TextRun& run : parse_rich_text(markup)) width += advance(context, select_face(context, run, style));
  return width;
}

TextStyle shrunk_to_fit(cairo_t* context, std::string_view markup, TextStyle style, double width) {
  const double needed = text_width(context, markup, style);
  if (needed > width) style.size *= std::max(width, 1.0) / needed;
  return style;
}

void draw_text(cairo_t* context, std::string_view markup, const TextStyle& style, double x, double y, TextAlign align) {
  if (auto* svg = SvgText::of(context)) return svg->add(context, parse_rich_text(markup), style, x, y, align);
  const double width = text_width(context, markup, style);
  if (align == TextAlign::centre) x -= width / 2;
  if (align == TextAlign::right) x -= width;
  cairo_set_source_rgb(context, style.colour.red, style.colour.green, style.colour.blue);
  for (const TextRun& run : parse_rich_text(markup)) {
    const std::string text = select_face(context, run, style);
    cairo_move_to(context, x, y + baseline_shift(run, style));
    cairo_show_text(context, text.c_str());
    x += advance(context, text);
  }
  cairo_new_path(context);
}

void draw_upward_text(cairo_t* context, std::string_view markup, const TextStyle& style, double x, double y) {
  cairo_save(context);
  cairo_translate(context, x, y);
  cairo_rotate(context, -1.5707963267948966);
  draw_text(context, markup, style, 0, 0, TextAlign::centre);
  cairo_restore(context);
}

}  // namespace netpocket
