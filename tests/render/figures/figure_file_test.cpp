#include "render/figures/figure_file.h"

#include <cairo.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>

#include "engine/base/file_error.h"
#include "render/figures/paper_figures.h"
#include "render/figures/rich_text.h"
#include "synthetic_run.h"
#include "test_directory.h"

namespace netpocket {
namespace {

namespace fs = std::filesystem;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

Figure simple_figure() {
  Figure figure;
  figure.title = "A line";
  figure.width_mm = 50.8;  // 2 inch
  figure.height_mm = 25.4;
  Panel panel;
  Curve curve;
  curve.x = {0, 1, 2};
  curve.y = {1, 3, 2};
  curve.colour = {1, 0, 0};
  panel.curves = {curve};
  figure.panels = {panel};
  return figure;
}

class FigureFile : public ::testing::Test {
 protected:
  FigureFile() : directory_(test_directory()) { fs::create_directories(directory_); }

  std::string read(const std::string& name) const {
    std::ifstream file(directory_ / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  fs::path directory_;
};

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t found = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++found;
  return found;
}

TEST_F(FigureFile, PngHasTheSizeAndStatesTheResolution) {
  save_figure(simple_figure(), directory_ / "line.png", 150);
  cairo_surface_t* image = cairo_image_surface_create_from_png((directory_ / "line.png").c_str());
  ASSERT_EQ(cairo_surface_status(image), CAIRO_STATUS_SUCCESS);
  EXPECT_EQ(cairo_image_surface_get_width(image), 300);
  EXPECT_EQ(cairo_image_surface_get_height(image), 150);
  cairo_surface_destroy(image);

  const std::string bytes = read("line.png");
  const std::size_t chunk = bytes.find("pHYs");
  ASSERT_NE(chunk, std::string::npos);
  // 150 dots per inch are 5906 = 0x1712 per metre.
  EXPECT_EQ(bytes.substr(chunk + 4, 9), std::string("\x00\x00\x17\x12\x00\x00\x17\x12\x01", 9));
}

TEST_F(FigureFile, SvgHasAPathForEveryCurve) {
  Figure figure = simple_figure();
  figure.panels.push_back(figure.panels[0]);
  figure.columns = 2;
  save_figure(figure, directory_ / "lines.svg");
  const std::string svg = read("lines.svg");
  EXPECT_TRUE(svg.starts_with("<?xml"));
  EXPECT_EQ(count(svg, "stroke:rgb(100%,0%,0%)"), 2u);
  EXPECT_EQ(count(svg, "<image"), 0u) << "curves must be vectors";
}

TEST_F(FigureFile, SvgTextIsText) {
  Figure figure = simple_figure();
  figure.title = "*F*_{y} < 5 & more";
  figure.panels[0].y.title = "upwards";
  figure.panels[0].curves[0].label = "first curve";
  save_figure(figure, directory_ / "line.svg");
  const std::string svg = read("line.svg");
  EXPECT_EQ(count(svg, "glyph"), 0u) << "no outlines of letters";
  EXPECT_EQ(count(svg, "<tspan font-style=\"italic\">F</tspan>"), 1u);
  EXPECT_EQ(count(svg, ">y</tspan>"), 1u);
  EXPECT_EQ(count(svg, " &lt; 5 &amp; more"), 1u);
  EXPECT_EQ(count(svg, ">first curve</text>"), 1u);
  EXPECT_EQ(count(svg, ">upwards</text>"), 1u);
  EXPECT_NE(svg.find("transform=\"matrix(", svg.rfind("<text", svg.find(">upwards"))), std::string::npos);
  EXPECT_EQ(count(svg, ">2</text>"), 2u) << "values on both axes";
  EXPECT_TRUE(svg.ends_with("</svg>\n"));
}

TEST_F(FigureFile, DraftsSaySoBelowTheirPanels) {
  std::vector<RunSeries> runs = {synthetic_run("case1", 10), synthetic_run("case_2", 7)};
  EXPECT_TRUE(make_figure("energy", runs).note.empty());
  runs[1].draft = "coarse mesh; bias over 512 scattered captures";
  const Figure figure = make_figure("energy", runs);
  EXPECT_EQ(figure.note, plain_text("Drafts are case_2: coarse mesh; bias over 512 scattered captures"));
  save_figure(figure, directory_ / "draft.svg");
  const std::string svg = read("draft.svg");
  EXPECT_NE(svg.find("scattered captures"), std::string::npos);
  runs[0].draft = runs[1].draft;
  EXPECT_EQ(make_figure("energy", runs).note, "Draft: coarse mesh; bias over 512 scattered captures");
}

TEST_F(FigureFile, PdfStartsWithItsSignature) {
  save_figure(simple_figure(), directory_ / "line.pdf");
  EXPECT_TRUE(read("line.pdf").starts_with("%PDF-"));
  EXPECT_NE(read("line.pdf").find("DejaVuSans"), std::string::npos) << "text must be text";
}

TEST_F(FigureFile, LeavesNoTemporaryFiles) {
  for (const char* name : {"a.png", "a.svg", "a.pdf"}) save_figure(simple_figure(), directory_ / name, 72);
  EXPECT_EQ(std::distance(fs::directory_iterator(directory_), fs::directory_iterator()), 3);
}

TEST_F(FigureFile, SaysWhyAFileCannotBeWritten) {
  try {
    save_figure(simple_figure(), directory_ / "missing" / "line.png");
    FAIL() << "no exception";
  } catch (const FileError& error) {
    EXPECT_NE(std::string(error.what()).find("missing/line.png\": No such file or directory"), std::string::npos)
        << error.what();
  }
  fs::create_directories(directory_ / "taken.png" / "inside");
  EXPECT_THROW(save_figure(simple_figure(), directory_ / "taken.png"), FileError);
  EXPECT_EQ(std::distance(fs::directory_iterator(directory_), fs::directory_iterator()), 1) << "temporary file left";
}

TEST_F(FigureFile, RefusesOtherFormatsAndEndlessPictures) {
  EXPECT_THROW(save_figure(simple_figure(), directory_ / "line.jpg"), FigureError);
  EXPECT_THROW(figure_format(""), FigureError);
  EXPECT_EQ(figure_format("svg"), FigureFormat::svg);
  EXPECT_EQ(figure_format(".pdf"), FigureFormat::pdf);
  for (const double resolution : {1e6, 0.0, -5.0, kNaN}) {
    EXPECT_THROW(encode_figure(simple_figure(), FigureFormat::png, resolution), FigureError) << resolution;
  }
}

TEST_F(FigureFile, ReducesLongCurvesInVectorOutput) {
  Figure figure = simple_figure();
  Curve& curve = figure.panels[0].curves[0];
  curve.x.clear();
  curve.y.clear();
  for (int i = 0; i < 500000; ++i) {
    curve.x.push_back(i);
    curve.y.push_back(i % 17);
  }
  // 2 inch at 600 columns per inch and 4 points of about 20 bytes each.
  EXPECT_LT(encode_figure(figure, FigureFormat::svg).size(), 150000u);
}

TEST_F(FigureFile, SurvivesOddData) {
  const std::vector<std::vector<double>> odd = {
      {}, {kNaN, kNaN, kNaN}, {1}, {5, 5, 5}, {0, kNaN, 1}, {1e300, -1e300, 0}, {1e-300, 0, 0}, {-INFINITY, 2, 3}};
  for (const std::vector<double>& values : odd) {
    Figure figure = simple_figure();
    figure.panels[0].curves[0].y = values;
    EXPECT_FALSE(encode_figure(figure, FigureFormat::png, 72).empty());
  }
  EXPECT_FALSE(encode_figure(Figure{}, FigureFormat::png, 72).empty());
}

TEST(DrawFigure, LaysOutAnewForTheSizeAndRestoresTheContext) {
  cairo_surface_t* image = cairo_image_surface_create(CAIRO_FORMAT_RGB24, 400, 300);
  cairo_t* context = cairo_create(image);
  draw_figure(simple_figure(), context, 400, 300);
  EXPECT_EQ(cairo_status(context), CAIRO_STATUS_SUCCESS);
  cairo_matrix_t matrix;
  cairo_get_matrix(context, &matrix);
  EXPECT_EQ(matrix.xx, 1);
  for (const double size : {1.0, 5.0, 40.0}) draw_figure(simple_figure(), context, size, size);
  EXPECT_EQ(cairo_status(context), CAIRO_STATUS_SUCCESS);
  cairo_destroy(context);
  cairo_surface_destroy(image);
}

}  // namespace
}  // namespace netpocket
