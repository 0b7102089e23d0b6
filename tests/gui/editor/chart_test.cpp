#include <gtest/gtest.h>

#include <QImage>
#include <QSignalSpy>
#include <QTest>
#include <cmath>
#include <set>

#include "gui/workbench/panels/chart_view.h"
#include "gui/workbench/panels/rich_label.h"
#include "gui/workbench/panels/tones.h"

namespace netpocket {
namespace {

Figure straight_line() {
  Curve curve;
  for (int i = 0; i <= 100; ++i) {
    curve.x.push_back(0.1 * i);
    curve.y.push_back(2.0 * i);
  }
  Panel panel;
  panel.curves = {curve};
  Figure figure;
  figure.panels = {panel};
  return figure;
}

TEST(TimeWindow, CutsAtExactTimes) {
  const Figure part = cut(straight_line(), {2.05, 3.33});
  const Curve& curve = part.panels[0].curves[0];
  EXPECT_EQ(curve.x.front(), 2.05);
  EXPECT_EQ(curve.x.back(), 3.33);
  EXPECT_NEAR(curve.y.front(), 41, 1e-9);
  EXPECT_NEAR(curve.y.back(), 66.6, 1e-9);
}

TEST(TimeWindow, ValuesAndGaps) {
  Curve curve;
  curve.x = {0, 1, 2, 3};
  curve.y = {0, 10, NAN, 30};
  EXPECT_NEAR(*value_at(curve, 0.25), 2.5, 1e-12);
  EXPECT_EQ(*value_at(curve, 1), 10);
  EXPECT_FALSE(value_at(curve, 1.5));
  EXPECT_EQ(*value_at(curve, 3), 30);
  EXPECT_FALSE(value_at(curve, 3.1));
  EXPECT_FALSE(value_at(curve, -0.1));
  EXPECT_FALSE(value_at(Curve{}, 0));
}

class Chart : public testing::Test {
 protected:
  Chart() {
    chart.resize(500, 300);
    chart.set_figure(straight_line());
    chart.show();
    chart.grab();  // paints
  }
  QPoint at(double time) { return chart.point_at(time)->toPoint(); }

  ChartView chart;
};

TEST_F(Chart, PointsAndTimesAreInverse) {
  for (const double time : {0.0, 2.5, 7.0}) EXPECT_NEAR(*chart.time_at(*chart.point_at(time)), time, 1e-9);
  EXPECT_FALSE(chart.time_at({1, 1})) << "outside the frame";
}

TEST_F(Chart, ClickTellsTheTime) {
  QSignalSpy clicked(&chart, &ChartView::time_clicked);
  QTest::mouseClick(&chart, Qt::LeftButton, {}, at(6));
  ASSERT_EQ(clicked.size(), 1);
  EXPECT_NEAR(clicked[0][0].toDouble(), 6, 0.03) << "to a pixel";
}

TEST_F(Chart, WheelZoomsAboutTheMouse) {
  const QPointF point = at(4);
  const double before = *chart.time_at(point);
  QWheelEvent event(point, chart.mapToGlobal(point), {}, {0, 240}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase,
                    false);
  QCoreApplication::sendEvent(&chart, &event);
  ASSERT_TRUE(chart.window());
  EXPECT_NEAR(chart.window()->length(), 10 / 1.44, 1e-9);
  chart.grab();
  // The frame may move by a pixel or two when tick labels change width.
  EXPECT_NEAR(*chart.time_at(point), before, 0.1);
}

TEST_F(Chart, DragPansAndDoubleClickShowsAll) {
  chart.set_window(TimeRange{4, 6});
  chart.grab();
  QSignalSpy clicked(&chart, &ChartView::time_clicked);
  QTest::mousePress(&chart, Qt::LeftButton, {}, at(5));
  QTest::mouseMove(&chart, at(4.5));
  QTest::mouseRelease(&chart, Qt::LeftButton, {}, at(4.5));
  EXPECT_NEAR(chart.window()->begin, 4.5, 0.02);
  EXPECT_EQ(clicked.size(), 0) << "a drag is no click";
  QTest::mouseDClick(&chart, Qt::LeftButton, {}, {250, 150});
  EXPECT_FALSE(chart.window());
}

TEST_F(Chart, TheCursorCanBeDragged) {
  chart.set_cursor(3.0);
  QSignalSpy clicked(&chart, &ChartView::time_clicked);
  QTest::mousePress(&chart, Qt::LeftButton, {}, at(3));
  QTest::mouseMove(&chart, at(5));
  ASSERT_GE(clicked.size(), 1);
  EXPECT_NEAR(clicked.back()[0].toDouble(), 5, 0.03);
  QTest::mouseRelease(&chart, Qt::LeftButton, {}, at(5));
}

TEST_F(Chart, WindowsStayWithinTheRun) {
  chart.set_window(TimeRange{-5, -3});
  EXPECT_EQ(*chart.window(), (TimeRange{0, 2}));
  chart.set_window(TimeRange{-5, 30});
  EXPECT_FALSE(chart.window());
  QTest::keyClick(&chart, Qt::Key_Plus);
  EXPECT_TRUE(chart.window());
  QTest::keyClick(&chart, Qt::Key_0);
  EXPECT_FALSE(chart.window());
}

// Runs of different lengths can be compared.
TEST_F(Chart, AllPanelsShowTheSameTimes) {
  Figure figure = straight_line();
  figure.panels.push_back(cut(figure, {0, 2}).panels[0]);
  chart.set_figure(figure);
  chart.grab();
  for (const Panel& panel : chart.shown_figure().panels) EXPECT_EQ(panel.x.limits, (AxisLimits{0, 10}));
  chart.set_window(TimeRange{1, 3});
  for (const Panel& panel : chart.shown_figure().panels) EXPECT_EQ(panel.x.limits, (AxisLimits{1, 3}));
}

TEST_F(Chart, ColumnsGiveWayToTheWidthUnlessRowsBecomeFlat) {
  Figure figure = straight_line();
  figure.panels.resize(6, figure.panels[0]);
  figure.columns = 2;
  chart.set_figure(figure);
  chart.resize(420, 380);
  EXPECT_EQ(chart.shown_figure().columns, 2) << "6 rows of 63 pixels cannot be read";
  chart.resize(420, 800);
  EXPECT_EQ(chart.shown_figure().columns, 1);
  chart.resize(240, 380);
  EXPECT_EQ(chart.shown_figure().columns, 1) << "nor panels of 120 pixels";
}

TEST(FigureImage, TakesTheGroundOfThePalette) {
  QPalette dark;
  dark.setColor(QPalette::Base, QColor(30, 33, 36));
  dark.setColor(QPalette::Text, Qt::white);
  const FigureImage image = figure_image(straight_line(), {200, 150}, 2, dark);
  EXPECT_EQ(image.image.size(), QSize(400, 300));
  EXPECT_EQ(image.image.pixelColor(1, 1), QColor(30, 33, 36));
  QPalette light;
  light.setColor(QPalette::Base, QColor(250, 250, 245));
  light.setColor(QPalette::Text, Qt::black);
  EXPECT_EQ(figure_image(straight_line(), {200, 150}, 1, light).image.pixelColor(1, 1), QColor(250, 250, 245));
}

TEST(FigureImage, LargerLettersTakeMoreOfThePicture) {
  const FigureImage usual = figure_image(straight_line(), {400, 300}, 1, QPalette());
  const FigureImage large = figure_image(straight_line(), {400, 300}, 1, QPalette(), 1.5);
  EXPECT_EQ(large.image.size(), usual.image.size());
  EXPECT_GT(large.panels[0].box.x, 1.2 * usual.panels[0].box.x);
  EXPECT_LT(large.panels[0].box.bottom(), usual.panels[0].box.bottom());
}

TEST(FigureImage, MirroredLightnessKeepsTheHue) {
  for (const QColor& colour : {QColor(0, 114, 178), QColor(213, 94, 0), QColor(200, 36, 32)}) {
    const QColor mirrored = mirrored_lightness(colour);
    EXPECT_NEAR(mirrored.hslHueF(), colour.hslHueF(), 0.01);
    EXPECT_NEAR(mirrored.lightnessF(), 1 - colour.lightnessF(), 0.01);
  }
}

// Contrast ratio of WCAG 2.1.
double contrast(const QColor& a, const QColor& b) {
  const auto luminance = [](const QColor& c) {
    const auto linear = [](double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); };
    return 0.2126 * linear(c.redF()) + 0.7152 * linear(c.greenF()) + 0.0722 * linear(c.blueF());
  };
  const double ratio = (luminance(a) + 0.05) / (luminance(b) + 0.05);
  return std::max(ratio, 1 / ratio);
}

TEST(Tones, AreReadable) {
  QPalette light;
  light.setColor(QPalette::Base, Qt::white);
  light.setColor(QPalette::Text, Qt::black);
  QPalette dark;
  dark.setColor(QPalette::Base, QColor(36, 36, 36));
  dark.setColor(QPalette::Text, Qt::white);
  for (const QPalette& palette : {light, dark}) {
    for (const Tone tone : {Tone::good, Tone::bad, Tone::warning, Tone::accent, Tone::muted}) {
      EXPECT_GE(contrast(tone_colour(tone, palette), palette.color(QPalette::Base)), 4.5) << static_cast<int>(tone);
      EXPECT_GE(contrast(tone_colour(tone, palette), ground_colour(tone, palette)), 4.5) << static_cast<int>(tone);
    }
  }
}

TEST(RichLabel, BecomesHtml) { EXPECT_EQ(to_html("*F_{x}* < 1"), "<i>F</i><sub><i>x</i></sub> &lt; 1"); }

}  // namespace
}  // namespace netpocket
