#include <cairo.h>

#include <sstream>

#include "render/figures/figure.h"
#include "render/figures/figure_style.h"
#include "render/figures/panel_layout.h"
#include "render/figures/panel_painter.h"

namespace netpocket {
namespace {

// "(a)", "(b)", ...; none for a single panel or beyond "(z)".
std::string panel_letter(std::size_t index, std::size_t count) {
  if (count < 2 || index >= 26) return "";
  return std::string("(") + static_cast<char>('a' + index) + ")";
}

// The words of a text in lines that keep within `width`, as far as single words do.
std::vector<std::string> broken_into_lines(cairo_t* context, const std::string& text, const TextStyle& style,
                                           double width) {
  std::vector<std::string> lines;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    const std::string longer = lines.empty() ? word : lines.back() + " " + word;
    if (!lines.empty() && text_width(context, longer, style) <= width) {
      lines.back() = longer;
    } else {
      lines.push_back(word);
    }
  }
  return lines;
}

}  // namespace

std::vector<PanelFrame> draw_figure(const Figure& figure, cairo_t* context, double width, double height) {
  cairo_save(context);
  cairo_set_source_rgb(context, 1, 1, 1);
  cairo_rectangle(context, 0, 0, width, height);
  cairo_fill(context);

  const double title_height = figure.title.empty() ? 0 : style::kFigureTitle.size * kLineHeight + style::kGap;
  const TextStyle title = shrunk_to_fit(context, figure.title, style::kFigureTitle, width - 2 * style::kOuterMargin);
  draw_text(context, figure.title, title, width / 2, style::kOuterMargin + kCapHeight * style::kFigureTitle.size,
            TextAlign::centre);
  const double inner_width = width - 2 * style::kOuterMargin, line_height = style::kFootnote.size * kLineHeight;
  const auto note = broken_into_lines(context, figure.note, style::kFootnote, inner_width);
  const double note_height = note.empty() ? 0 : static_cast<double>(note.size()) * line_height + style::kGap;
  for (std::size_t i = 0; i < note.size(); ++i) {
    const double below = static_cast<double>(note.size() - 1 - i) * line_height + style::kOuterMargin;
    draw_text(context, note[i], style::kFootnote, style::kOuterMargin, height - below, TextAlign::left);
  }
  const PlotBox area{style::kOuterMargin, style::kOuterMargin + title_height, inner_width,
                     height - 2 * style::kOuterMargin - title_height - note_height};
  const std::vector<PanelLayout> layouts = lay_out_panels(figure, context, area);
  std::vector<PanelFrame> frames;
  for (std::size_t i = 0; i < layouts.size(); ++i) {
    paint_panel(context, figure.panels[i], layouts[i], panel_letter(i, layouts.size()));
    frames.push_back({layouts[i].frame, layouts[i].x_limits, layouts[i].y_limits});
  }
  cairo_restore(context);
  return frames;
}

}  // namespace netpocket
