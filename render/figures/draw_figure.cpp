#include <cairo.h>

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
  const PlotBox area{style::kOuterMargin, style::kOuterMargin + title_height, width - 2 * style::kOuterMargin,
                     height - 2 * style::kOuterMargin - title_height};
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
