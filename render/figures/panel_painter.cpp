#include "render/figures/panel_painter.h"

#include <algorithm>
#include <cmath>

#include "render/figures/curve_pen.h"
#include "render/figures/figure_style.h"

namespace netpocket {
namespace {

class PanelPainter {
 public:
  PanelPainter(cairo_t* context, const Panel& panel, const PanelLayout& layout)
      : context_(context), panel_(panel), layout_(layout), frame_(layout.frame), map_(layout.map()) {}

  void paint(const std::string& letter) {
    paint_title(letter);
    if (layout_.has_data) {
      paint_phase_tints();
      paint_grid();
      paint_phase_boundaries();
      paint_curves();
      draw_legend(context_, panel_.curves, layout_.legend);
      paint_phase_labels();
      paint_ticks();
    } else {
      paint_note();
    }
    paint_frame();
    paint_axis_titles();
  }

 private:
  double paper_x(double x) const { return map_(x, 0).x; }
  double paper_y(double y) const { return map_(0, y).y; }

  void set_colour(const FigureColour& colour) { cairo_set_source_rgb(context_, colour.red, colour.green, colour.blue); }

  void line(double x1, double y1, double x2, double y2) {
    cairo_move_to(context_, x1, y1);
    cairo_line_to(context_, x2, y2);
  }

  void stroke(const FigureColour& colour, double width) {
    set_colour(colour);
    cairo_set_line_width(context_, width);
    cairo_set_line_cap(context_, CAIRO_LINE_CAP_BUTT);
    cairo_stroke(context_);
  }

  void paint_title(const std::string& letter) {
    const double baseline = frame_.y - style::kGap - 0.1 * style::kPanelTitle.size;
    double x = frame_.x;
    if (!letter.empty()) {
      draw_text(context_, letter, style::kPanelLetter, x, baseline, TextAlign::left);
      x += text_width(context_, letter + "  ", style::kPanelLetter);
    }
    const double free = frame_.right() + style::kRightMargin - x;
    draw_text(context_, panel_.title, shrunk_to_fit(context_, panel_.title, style::kPanelTitle, free), x, baseline,
              TextAlign::left);
  }

  // The part of a phase inside the limits, on paper.
  PlotBox phase_box(const PhaseBand& phase) const {
    const double left = paper_x(std::clamp(phase.begin, layout_.x_limits.low, layout_.x_limits.high));
    const double right = paper_x(std::clamp(phase.end, layout_.x_limits.low, layout_.x_limits.high));
    return {left, frame_.y, right - left, frame_.height};
  }

  void paint_phase_tints() {
    for (const PhaseBand& phase : panel_.phases) {
      const PlotBox box = phase_box(phase);
      set_colour(lighter(phase.colour, 0.95));
      cairo_rectangle(context_, box.x, box.y, box.width, box.height);
      cairo_fill(context_);
    }
  }

  void paint_phase_boundaries() {
    const double dash[] = {3, 2};
    cairo_set_dash(context_, dash, 2, 0);
    for (const PhaseBand& phase : panel_.phases) {
      const PlotBox box = phase_box(phase);
      if (box.x <= frame_.x || box.x >= frame_.right()) continue;
      line(box.x, frame_.y, box.x, frame_.bottom());
      stroke(kGrey, 0.6);
    }
    cairo_set_dash(context_, nullptr, 0, 0);
  }

  void paint_phase_labels() {
    for (const PhaseBand& phase : panel_.phases) {
      const PlotBox box = phase_box(phase);
      TextStyle text = style::kPhaseLabel;
      text.colour = phase.colour;
      const bool meets_ticks = box.x <= frame_.x || box.right() >= frame_.right();
      const double clearance = 1 + (meets_ticks ? style::kMajorTick : 0);
      if (text_width(context_, phase.label, text) + 2 * clearance > box.width) continue;
      const double baseline = frame_.y + style::kPhaseStrip - 1.2;
      draw_text(context_, phase.label, text, box.x + box.width / 2, baseline, TextAlign::centre);
    }
  }

  void paint_grid() {
    for (const double x : layout_.x_ticks.major) line(paper_x(x), frame_.y, paper_x(x), frame_.bottom());
    for (const double y : layout_.y_ticks.major) line(frame_.x, paper_y(y), frame_.right(), paper_y(y));
    stroke(style::kGrid, style::kGridLine);
    if (layout_.y_limits.low < 0 && layout_.y_limits.high > 0) {
      line(frame_.x, paper_y(0), frame_.right(), paper_y(0));
      stroke(style::kZeroLine, style::kGridLine);
    }
  }

  // Width below which detail cannot be seen: a quarter of a pixel, or 1/600 inch on paper.
  double column_width() const {
    if (cairo_surface_get_type(cairo_get_target(context_)) != CAIRO_SURFACE_TYPE_IMAGE) return 72.0 / 600;
    double dx = 0.25;
    double dy = 0;
    cairo_device_to_user_distance(context_, &dx, &dy);
    return std::hypot(dx, dy);
  }

  void paint_curves() {
    cairo_save(context_);
    cairo_rectangle(context_, frame_.x, frame_.y, frame_.width, frame_.height);
    cairo_clip(context_);
    for (const Curve& curve : panel_.curves) {
      for (const Polyline& line : map_curve(curve.x, curve.y, map_)) paint_curve(curve, line);
    }
    cairo_restore(context_);
  }

  void paint_curve(const Curve& curve, const Polyline& mapped) {
    const bool is_point = mapped.size() == 1 && curve.marker != Marker::none;
    if (!is_point) stroke_line(context_, curve, decimate(mapped, column_width()));
    if (curve.marker == Marker::none) return;
    for (const Point& point : mapped) draw_marker(context_, curve, point);
  }

  void paint_ticks() {
    for (const double x : layout_.x_ticks.major) x_tick(x, style::kMajorTick);
    for (const double x : layout_.x_ticks.minor) x_tick(x, style::kMinorTick);
    for (const double y : layout_.y_ticks.major) y_tick(y, style::kMajorTick);
    for (const double y : layout_.y_ticks.minor) y_tick(y, style::kMinorTick);
    stroke(style::kFrame, style::kFrameLine);

    const double size = style::kTickLabel.size;
    for (std::size_t i = 0; i < layout_.x_ticks.major.size(); ++i) {
      draw_text(context_, layout_.x_ticks.labels[i], style::kTickLabel, paper_x(layout_.x_ticks.major[i]),
                frame_.bottom() + style::kGap + kCapHeight * size, TextAlign::centre);
    }
    for (std::size_t i = 0; i < layout_.y_ticks.major.size(); ++i) {
      draw_text(context_, layout_.y_ticks.labels[i], style::kTickLabel, frame_.x - style::kGap,
                paper_y(layout_.y_ticks.major[i]) + kCapHeight * size / 2, TextAlign::right);
    }
    draw_text(context_, layout_.y_ticks.multiplier, style::kTickLabel, frame_.x - 2 * style::kGap,
              frame_.y - style::kGap - 0.1 * size, TextAlign::right);
  }

  void x_tick(double x, double length) {
    line(paper_x(x), frame_.bottom(), paper_x(x), frame_.bottom() - length);
    line(paper_x(x), frame_.y, paper_x(x), frame_.y + length);
  }

  void y_tick(double y, double length) {
    line(frame_.x, paper_y(y), frame_.x + length, paper_y(y));
    line(frame_.right(), paper_y(y), frame_.right() - length, paper_y(y));
  }

  void paint_note() {
    draw_text(context_, panel_.empty, style::kNote, frame_.x + frame_.width / 2,
              frame_.y + (frame_.height + kCapHeight * style::kNote.size) / 2, TextAlign::centre);
  }

  void paint_frame() {
    cairo_rectangle(context_, frame_.x, frame_.y, frame_.width, frame_.height);
    stroke(style::kFrame, style::kFrameLine);
  }

  void paint_axis_titles() {
    const std::string& factor = layout_.x_ticks.multiplier;
    const std::string x_title = factor.empty() ? panel_.x.title : panel_.x.title + "   " + factor;
    draw_text(context_, x_title, style::kAxisTitle, frame_.x + frame_.width / 2,
              frame_.bottom() + 2 * style::kGap + style::kTickLabel.size + kCapHeight * style::kAxisTitle.size,
              TextAlign::centre);
    draw_upward_text(context_, panel_.y.title, style::kAxisTitle, layout_.y_title_baseline,
                     frame_.y + frame_.height / 2);
  }

  cairo_t* context_;
  const Panel& panel_;
  const PanelLayout& layout_;
  const PlotBox frame_;
  const PaperMap map_;
};

}  // namespace

void paint_panel(cairo_t* context, const Panel& panel, const PanelLayout& layout, const std::string& letter) {
  PanelPainter(context, panel, layout).paint(letter);
}

}  // namespace netpocket
