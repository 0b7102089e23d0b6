#include <cairo.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "render/figures/curve_pen.h"
#include "render/figures/panel_layout.h"
#include "render/figures/paper_figures.h"
#include "synthetic_run.h"

namespace netpocket {
namespace {

// A picture in memory and a context on it.
class Canvas {
 public:
  Canvas(int width, int height)
      : surface_(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height)), context_(cairo_create(surface_)) {
    cairo_set_source_rgb(context_, 1, 1, 1);
    cairo_paint(context_);
  }
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;
  ~Canvas() {
    cairo_destroy(context_);
    cairo_surface_destroy(surface_);
  }

  cairo_t* context() const { return context_; }

  int green(int column, int row) const {
    cairo_surface_flush(surface_);
    return cairo_image_surface_get_data(surface_)[row * cairo_image_surface_get_stride(surface_) + 4 * column + 1];
  }

 private:
  cairo_surface_t* surface_;
  cairo_t* context_;
};

std::vector<PanelLayout> lay_out(const Figure& figure) {
  const Canvas canvas(10, 10);
  return lay_out_panels(figure, canvas.context(), {0, 0, figure.width(), figure.height()});
}

TEST(Layout, NoLegendOfThePapersFiguresHidesACurve) {
  const std::vector<RunSeries> runs = {synthetic_run("case1", 10), synthetic_run("case2", 7.5),
                                       synthetic_run("case3", 5)};
  for (const std::string& name : figure_names()) {
    for (std::size_t count = 1; count <= runs.size(); ++count) {
      const Figure figure = make_figure(name, {runs.begin(), runs.begin() + static_cast<std::ptrdiff_t>(count)});
      for (const PanelLayout& layout : lay_out(figure)) {
        EXPECT_EQ(layout.legend.hidden, 0) << name << " of " << count << " runs";
        if (layout.legend.empty()) continue;
        EXPECT_GE(layout.legend.box.x, layout.frame.x);
        EXPECT_LE(layout.legend.box.right(), layout.frame.right());
      }
    }
  }
}

TEST(Layout, GivesALegendRoomAboveCurvesThatFillTheFrame) {
  Curve noise;
  noise.label = "noise";
  for (int i = 0; i < 2000; ++i) {
    noise.x.push_back(i);
    noise.y.push_back(i % 2);
  }
  Figure figure;
  figure.panels.resize(1);
  figure.panels[0].curves = {noise};
  const PanelLayout layout = lay_out(figure)[0];
  EXPECT_EQ(layout.legend.hidden, 0);
  EXPECT_GT(layout.y_limits.high, 1.1);
  EXPECT_NEAR(layout.y_limits.low, -0.06, 1e-12);
}

TEST(Layout, SharesLimitsWithinAGroupOnly) {
  Figure figure;
  figure.panels.resize(3);
  figure.columns = 3;
  for (int i = 0; i < 3; ++i) {
    Curve curve;
    curve.x = {0, 1};
    curve.y = {0, std::pow(10.0, i)};
    figure.panels[static_cast<std::size_t>(i)].curves = {curve};
  }
  figure.panels[0].y_group = 0;
  figure.panels[2].y_group = 0;
  const std::vector<PanelLayout> layouts = lay_out(figure);
  EXPECT_EQ(layouts[0].y_limits, layouts[2].y_limits);
  EXPECT_LT(layouts[1].y_limits.high, 11);
  EXPECT_EQ(layouts[0].frame.width, layouts[2].frame.width);
  EXPECT_EQ(layouts[0].frame.y, layouts[1].frame.y);
}

// 200 points in every pixel column: the picture of the reduced curve is that of the whole one.
TEST(Decimate, DoesNotChangeThePicture) {
  constexpr int kSize = 400;
  Polyline line;
  for (int i = 0; i < kSize * 200; ++i) {
    const double x = i / 200.0;
    const double y = 0.5 * kSize + 80 * std::sin(0.02 * x) + 60 * std::sin(31.0 * x) * std::exp(-x / 150);
    line.push_back({x, y});
  }
  const Canvas whole(kSize, kSize);
  const Canvas reduced(kSize, kSize);
  stroke_line(whole.context(), Curve{}, line);
  stroke_line(reduced.context(), Curve{}, decimate(line, 0.25));
  int different = 0;
  int inked = 0;
  for (int row = 0; row < kSize; ++row) {
    for (int column = 0; column < kSize; ++column) {
      if (whole.green(column, row) < 255) ++inked;
      if (std::abs(whole.green(column, row) - reduced.green(column, row)) > 0.1 * 255) ++different;
    }
  }
  // Measured 0; columns of one pixel give a tenth of the inked pixels.
  std::printf("%d of %d inked pixels differ by more than a tenth\n", different, inked);
  EXPECT_GT(inked, 10000);
  EXPECT_LT(different, 0.002 * inked);
}

}  // namespace
}  // namespace netpocket
