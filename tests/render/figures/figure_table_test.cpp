#include "render/figures/figure_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include "render/figures/paper_figures.h"
#include "synthetic_run.h"

namespace netpocket {
namespace {

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

TEST(FigureTable, HasALineForEachPoint) {
  Figure figure;
  Panel panel;
  panel.title = "Force *F_{y}*, net";
  panel.x.title = "Time *t* (s)";
  panel.y.title = "Force *F_{y}* (N)";
  Curve named, labelled, bare;
  named.x = {0, 0.1, 0.2 + 3e-14};
  named.y = {1.0 / 3, kNoNumber, -2e-9};
  named.name = "the \"first\"";
  labelled.x = {5};
  labelled.y = {6};
  labelled.label = "at 10^{2} s";
  bare.x = {7};
  bare.y = {8};
  panel.curves = {named, labelled, bare};
  figure.panels = {Panel(), panel};
  const std::string start = "2,\"Force F_y, net\",";
  EXPECT_EQ(lines_of(figure_csv(figure)),
            (std::vector<std::string>{"panel,title,curve,x_axis,x,y_axis,y",
                                      start + "\"the \"\"first\"\"\",Time t (s),0,Force F_y (N),0.3333333333333333",
                                      start + "\"the \"\"first\"\"\",Time t (s),0.2,Force F_y (N),-2e-09",
                                      start + "at 10^2 s,Time t (s),5,Force F_y (N),6",
                                      start + "curve 3,Time t (s),7,Force F_y (N),8"}));
}

TEST(FigureTable, NamesOfAnAxisStandForNumbers) {
  Figure figure;
  Panel panel;
  panel.y.names = {{1, "spin, x"}, {2, "mass"}};
  Curve curve;
  curve.x = {0.5, 0.25};
  curve.y = {1, 2};
  panel.curves = {curve};
  figure.panels = {panel};
  const auto lines = lines_of(figure_csv(figure));
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(lines[1], "1,,curve 1,,0.5,,\"spin, x\"");
  EXPECT_EQ(lines[2], "1,,curve 1,,0.25,,mass");
}

// Whoever reads the table can tell the curves of two runs apart, and finds every value of the run in it.
TEST(FigureTable, HoldsTheRunsOfAFigure) {
  const std::vector<RunSeries> runs = {synthetic_run("slow", 10), synthetic_run("fast", 5)};
  const std::string table = figure_csv(make_figure("figure03_closing", runs));
  for (const std::string run : {"slow", "fast"}) {
    for (const std::string channel : {"commanded_length", "closing_length", "commanded_speed", "closing_speed"}) {
      EXPECT_NE(table.find("," + run + ": " + channel + ","), table.npos) << run << channel;
    }
  }
  std::size_t values = 0;
  for (const RunSeries& run : runs) values += 4 * run.times().size();
  EXPECT_EQ(lines_of(table).size(), values + 1);
}

TEST(FigureTable, StandsBesideTheFigure) {
  EXPECT_EQ(table_beside("figures/energy.pdf"), std::filesystem::path("figures/energy.csv"));
}

}  // namespace
}  // namespace netpocket
