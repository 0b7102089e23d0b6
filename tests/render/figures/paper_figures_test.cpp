#include <cairo.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <set>

#include "engine/base/file_error.h"
#include "render/figures/plot_figures.h"
#include "synthetic_run.h"
#include "test_directory.h"

namespace netpocket {
namespace {

namespace fs = std::filesystem;

std::vector<RunSeries> three_cases() {
  return {synthetic_run("case1", 10), synthetic_run("case2", 7.5), synthetic_run("case3", 5)};
}

struct Picture {
  int width = 0;
  int height = 0;
  double ink = 0;  // share of pixels that are not white
  std::size_t colours = 0;
};

Picture look_at(const fs::path& file) {
  Picture picture;
  cairo_surface_t* image = cairo_image_surface_create_from_png(file.c_str());
  picture.width = cairo_image_surface_get_width(image);
  picture.height = cairo_image_surface_get_height(image);
  std::set<std::uint32_t> colours;
  std::size_t inked = 0;
  for (int row = 0; row < picture.height; ++row) {
    const auto* pixels = reinterpret_cast<const std::uint32_t*>(cairo_image_surface_get_data(image) +
                                                                row * cairo_image_surface_get_stride(image));
    for (int column = 0; column < picture.width; ++column) {
      const std::uint32_t colour = pixels[column] & 0xffffff;
      colours.insert(colour);
      if (colour != 0xffffff) ++inked;
    }
  }
  cairo_surface_destroy(image);
  picture.ink = static_cast<double>(inked) / (picture.width * picture.height);
  picture.colours = colours.size();
  return picture;
}

class PaperFigures : public ::testing::Test {
 protected:
  PaperFigures() : directory_(test_directory()) {}

  // Every picture has its size and is not blank. They stay in the directory, to be looked at.
  void expect_pictures(const std::vector<RunSeries>& runs, const fs::path& directory) {
    const std::vector<fs::path> files = plot_figures(runs, directory);
    ASSERT_EQ(files.size(), 7u);
    for (const fs::path& file : files) {
      SCOPED_TRACE(file.string());
      const Figure figure = make_figure(file.stem().string(), runs);
      const Picture picture = look_at(file);
      EXPECT_NEAR(picture.width, figure.width_mm / 25.4 * 300, 0.5);
      EXPECT_NEAR(picture.height, figure.height_mm / 25.4 * 300, 0.5);
      EXPECT_GT(picture.colours, 50u);
      EXPECT_GT(picture.ink, 0.2);  // tinted panels; an empty frame has none
    }
  }
  fs::path directory_;
};

TEST_F(PaperFigures, OfOneRun) { expect_pictures({synthetic_run("case1", 10)}, directory_); }

TEST_F(PaperFigures, OfThreeRuns) { expect_pictures(three_cases(), directory_); }

TEST_F(PaperFigures, HaveThePanelsAndCurvesOfThePaper) {
  const std::vector<RunSeries> one = {synthetic_run("case1", 10)};
  const auto shape = [](const Figure& figure) {
    std::vector<std::size_t> curves;
    for (const Panel& panel : figure.panels) curves.push_back(panel.curves.size());
    return curves;
  };
  using Shape = std::vector<std::size_t>;
  EXPECT_EQ(shape(make_figure("figure03_closing", one)), (Shape{2, 2}));
  EXPECT_EQ(shape(make_figure("figure05_force", one)), (Shape{1, 2, 1}));  // F_x, F_y and its peak, F_z
  EXPECT_EQ(shape(make_figure("figure06_position", one)), (Shape{2, 2, 2, 2}));
  EXPECT_EQ(shape(make_figure("figure03_closing", three_cases())), (Shape{7, 7}));  // and a legend entry
  EXPECT_EQ(shape(make_figure("figure09_force", three_cases())), (Shape{1, 1, 1, 2, 2, 2, 1, 1, 1}));
  EXPECT_EQ(shape(make_figure("figure10_target_position", three_cases())), (Shape{2, 2, 2, 2, 2, 2}));
  EXPECT_EQ(shape(make_figure("tension", three_cases())), (Shape{3, 3}));
  EXPECT_EQ(shape(make_figure("tension", one)), (Shape{2, 2}));  // and their peaks
}

// A run of another system: three frames, a tether, an area, no closing ropes.
RunSeries run_of_another_system() {
  RunSeries run;
  run.name = "thrown";
  run.begin(
      std::make_shared<const ChannelList>(std::vector<ChannelInfo>{{"time", "s", "time"},
                                                                   channel_info(Channel::rope_tension_max),
                                                                   {"net_area", "m^2", "area of the net"},
                                                                   {"spin", "kg m^2/s", ""},
                                                                   {"tether_tension", "N", "tension of the tether"},
                                                                   {"drum_torque", "N m", "torque of the drum"}}));
  run.append({0, 1, 2, 0, 0, 5});
  run.append({0.5, 7, 3, 1, 1234.56, 6});
  run.append({1, 2, 4, 0, 0.25, 7});
  return run;
}

TEST_F(PaperFigures, HaveAPanelForEachTensionThatARunHas) {
  const Figure figure = make_figure("tension", {run_of_another_system()});
  ASSERT_EQ(figure.panels.size(), 2u);  // none for closing ropes, which it has not
  EXPECT_EQ(figure.panels[0].title, "Largest tension in a net cord");
  EXPECT_EQ(figure.panels[1].title, "Tension of the tether");
  ASSERT_EQ(figure.panels[1].curves.size(), 2u);  // and its peak
  EXPECT_EQ(figure.panels[1].curves[0].y, (std::vector<double>{0, 1234.56, 0.25}));
  EXPECT_EQ(figure.panels[1].curves[1].label, "1234.6 N at 0.50 s");
  EXPECT_EQ(figure.panels[0].curves[1].label, "7.00 N at 0.50 s");
  for (const Panel& panel : make_figure("tension", {run_of_another_system(), run_of_another_system()}).panels) {
    EXPECT_EQ(panel.curves.size(), 2u);  // a curve for each run
  }
}

TEST_F(PaperFigures, RaiseThePowersOfUnits) {
  const Figure figure = make_figure("own_channels", {run_of_another_system()});
  ASSERT_EQ(figure.panels.size(), 4u);
  EXPECT_EQ(figure.panels[0].y.title, "Net area (m^{2})");
  EXPECT_EQ(figure.panels[1].y.title, "Spin (kg m^{2}/s)");
  EXPECT_EQ(figure.panels[2].y.title, "Tether tension (N)");
  EXPECT_EQ(figure.panels[2].curves.back().label, "1234.6 N at 0.50 s");
  EXPECT_EQ(figure.panels[3].curves.size(), 1u);  // a torque has no mark
}

TEST_F(PaperFigures, MarkNoPeakWhereThereIsNone) {
  RunSeries run = run_of_another_system();
  run.channels[*run.channel_list->find("tether_tension")] = {0, 0, 0};
  EXPECT_EQ(make_figure("tension", {run}).panels[1].curves.size(), 1u);
}

TEST_F(PaperFigures, ColourThePhasesAsThePaperDoes) {
  const RunSeries run = synthetic_run("case2", 7.5);
  const Panel panel = make_figure("figure10_target_position", {run}).panels[0];
  const Curve& closing = panel.curves[0];
  const Curve& towing = panel.curves[1];
  EXPECT_GT(closing.colour.blue, closing.colour.red);
  EXPECT_GT(towing.colour.red, towing.colour.blue);
  EXPECT_EQ(closing.x.back(), 10);  // the paper's capturing phase lasts until towing starts
  EXPECT_EQ(towing.x.front(), 10);
  EXPECT_EQ(closing.x.size() + towing.x.size(), run.times().size() + 1);  // they meet in one sample
  ASSERT_EQ(panel.phases.size(), 3u);
  EXPECT_EQ(panel.phases[1].begin, 7.5);
  EXPECT_EQ(panel.phases[1].end, 10);
}

TEST_F(PaperFigures, EndTheClosingBandWhereTowingStartsEarly) {
  RunSeries run = synthetic_run("early", 10);
  run.phases = pocket_phases(0, 10, 6);
  const std::vector<PhaseBand> phases = make_figure("figure05_force", {run}).panels[0].phases;
  ASSERT_EQ(phases.size(), 2u);
  EXPECT_EQ(phases[0].end, 6);
  EXPECT_EQ(phases[1].begin, 6);
}

TEST_F(PaperFigures, StateTheEnergyErrorInPercent) {
  RunSeries run = synthetic_run("case1", 10);
  std::fill(run.channel(Channel::energy_input).begin(), run.channel(Channel::energy_input).end(), 50);
  const auto title = [&](double error) {
    std::fill(run.channel(Channel::energy_error).begin(), run.channel(Channel::energy_error).end(), error);
    return make_figure("energy", {run}).panels.back().title;
  };
  EXPECT_EQ(title(-0.17), "Error, at most 0.34 % of the input");
  EXPECT_EQ(title(0.00613), "Error, at most 0.012 % of the input");
  EXPECT_EQ(title(75), "Error, at most 150 % of the input");
  EXPECT_EQ(title(1e-9), "Error, below 0.001 % of the input");
}

TEST_F(PaperFigures, ShowWhereEnergyIsSpent) {
  const RunSeries run = synthetic_run("case1", 10);
  const std::vector<Panel> panels = make_figure("energy", {run}).panels;
  ASSERT_EQ(panels.size(), 3u);
  EXPECT_EQ(panels[0].curves.back().y, run.channel(Channel::energy_contact));
  EXPECT_EQ(panels[0].curves.back().label, "contact springs");
  const Channel parts[] = {Channel::spent_in_cords, Channel::spent_at_hinges, Channel::spent_in_contacts,
                           Channel::spent_by_friction};
  ASSERT_EQ(panels[1].curves.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(panels[1].curves[i].y, run.channel(parts[i]));
}

// As in recordings by version 0.1.
TEST_F(PaperFigures, LeaveOutWhatWasNotRecorded) {
  RunSeries run = synthetic_run("case1", 10);
  for (const Channel c : {Channel::energy_contact, Channel::spent_in_cords, Channel::spent_at_hinges,
                          Channel::spent_in_contacts, Channel::spent_by_friction}) {
    run.channel(c).assign(run.times().size(), std::numeric_limits<double>::quiet_NaN());
  }
  const std::vector<Panel> panels = make_figure("energy", {run, synthetic_run("case2", 7.5)}).panels;
  ASSERT_EQ(panels.size(), 6u);
  EXPECT_EQ(panels[0].curves.size(), 4u);
  EXPECT_EQ(panels[1].title, "case1: dissipated; parts not recorded");
  ASSERT_EQ(panels[1].curves.size(), 1u);
  EXPECT_EQ(panels[1].curves[0].y, run.channel(Channel::energy_dissipated));
  EXPECT_EQ(panels[3].curves.size(), 5u);
  EXPECT_EQ(panels[4].title, "case2: dissipated");
}

TEST_F(PaperFigures, LeaveOutPhasesThatAreNotKnown) {
  RunSeries run = synthetic_run("free", 10);
  run.phases.clear();
  const Panel panel = make_figure("figure11_spacecraft_position", {run}).panels[0];
  EXPECT_TRUE(panel.phases.empty());
  EXPECT_EQ(panel.curves[0].x.size(), run.times().size());
  EXPECT_TRUE(panel.curves[1].x.empty());
}

TEST_F(PaperFigures, MarkTheLargestAxialForce) {
  RunSeries run = synthetic_run("case1", 10);
  run.channel(Channel::contact_fy)[600] = -123.45;
  const Curve peak = make_figure("figure05_force", {run}).panels[1].curves.back();
  EXPECT_EQ(peak.x, std::vector<double>{run.times()[600]});
  EXPECT_EQ(peak.y, std::vector<double>{-123.45});
}

TEST_F(PaperFigures, SayNoDataWhenThereIsNone) {
  RunSeries empty;
  empty.name = "empty";
  RunSeries broken = synthetic_run("broken", 10);
  for (std::vector<double>& values : broken.channels) {
    std::fill(values.begin(), values.end(), std::numeric_limits<double>::quiet_NaN());
  }
  RunSeries short_channel = synthetic_run("short", 10);
  short_channel.channel(Channel::contact_fy).resize(3);
  PlotOptions coarse;
  coarse.resolution = 72;
  EXPECT_EQ(plot_figures({}, directory_ / "none", coarse).size(), 7u);
  EXPECT_EQ(plot_figures({empty}, directory_ / "empty", coarse).size(), 7u);
  EXPECT_EQ(plot_figures({broken}, directory_ / "nan", coarse).size(), 7u);
  EXPECT_EQ(plot_figures({short_channel, empty, broken}, directory_ / "odd", coarse).size(), 7u);
}

TEST_F(PaperFigures, AreTheSameEveryTime) {
  const Figure figure = make_figure("figure09_force", three_cases());
  EXPECT_TRUE(encode_figure(figure, FigureFormat::png, 100) == encode_figure(figure, FigureFormat::png, 100));
}

TEST_F(PaperFigures, WriteTheChosenFiguresInTheChosenFormat) {
  PlotOptions options;
  options.format = FigureFormat::pdf;
  options.names = {"energy", "figure05_force"};
  const std::vector<fs::path> files = plot_figures(three_cases(), directory_ / "a" / "b", options);
  EXPECT_EQ(files, (std::vector<fs::path>{directory_ / "a" / "b" / "energy.pdf",
                                          directory_ / "a" / "b" / "figure05_force.pdf"}));
  for (const fs::path& file : files) EXPECT_TRUE(fs::exists(file));
}

std::string message_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const FigureError& error) {
    return error.what();
  }
  return "no exception";
}

TEST_F(PaperFigures, SuggestTheNearestName) {
  const auto message = [](const char* name) { return message_of([&] { make_figure(name, {}); }); };
  EXPECT_EQ(message("figure03_closng"), "unknown figure 'figure03_closng'; did you mean 'figure03_closing'?");
  EXPECT_EQ(message("figure3"), "unknown figure 'figure3'; did you mean 'figure03_closing'?");
  EXPECT_EQ(message("force"), "unknown figure 'force'; did you mean 'figure05_force'?");
  EXPECT_EQ(message("Energy"), "unknown figure 'Energy'; did you mean 'energy'?");
}

TEST_F(PaperFigures, WriteNothingWhenANameIsUnknown) {
  PlotOptions options;
  options.names = {"energy", "enrgy"};
  EXPECT_THROW(plot_figures(three_cases(), directory_ / "c", options), FigureError);
  EXPECT_FALSE(fs::exists(directory_ / "c"));
}

TEST_F(PaperFigures, SayWhyADirectoryCannotBeUsed) {
  try {
    plot_figures({}, "/proc/figures");
    FAIL() << "no exception";
  } catch (const FileError& error) {
    EXPECT_TRUE(std::string(error.what()).starts_with("cannot make the folder \"/proc/figures\": ")) << error.what();
  }
}

// A vector loop, two scalar loops of one table, and a disturbance that acts.
RunSeries run_with_loops(const std::string& name) {
  RunSeries run;
  run.name = name;
  run.begin(std::make_shared<const ChannelList>(std::vector<ChannelInfo>{{"time", "s", ""},
                                                                         {"e_x", "rad", "error"},
                                                                         {"e_y", "rad", "error"},
                                                                         {"e_z", "rad", "error"},
                                                                         {"c_x", "N m", ""},
                                                                         {"c_y", "N m", ""},
                                                                         {"c_z", "N m", ""},
                                                                         {"d_x", "N m", ""},
                                                                         {"d_y", "N m", ""},
                                                                         {"d_z", "N m", ""},
                                                                         {"length_1", "m", ""},
                                                                         {"length_2", "m", ""},
                                                                         {"wanted_1", "m", ""},
                                                                         {"wanted_2", "m", ""},
                                                                         {"torque_1", "N m", ""},
                                                                         {"torque_2", "N m", ""},
                                                                         {"disturbance_on_target_force_x", "N", ""},
                                                                         {"disturbance_on_target_force_y", "N", ""},
                                                                         {"disturbance_on_target_force_z", "N", ""},
                                                                         {"other", "kg", ""}}));
  for (const double t : {0.0, 1.0}) run.append({t, 3, 0, 4, 1, 1, 1, 2, 0, 0, 5, 6, 7, 8, 9, 10, 0, t, 0, 1});
  ControlLoopInfo attitude{"Attitude PD", "spacecraft", "attitude", "controller.0"};
  attitude.actual = attitude.error = {"e_x", "e_y", "e_z"};
  attitude.commanded = {"c_x", "c_y", "c_z"};
  attitude.delivered = {"d_x", "d_y", "d_z"};
  run.loops = {attitude};
  for (const std::string i : {"1", "2"}) {
    ControlLoopInfo winch{"Winch " + i, "rope " + i, "length", "winch"};
    winch.actual = {"length_" + i};
    winch.set_point = {"wanted_" + i};
    winch.delivered = {"torque_" + i};
    run.loops.push_back(winch);
  }
  return run;
}

TEST_F(PaperFigures, ControlLoopsHaveARowEach) {
  const Figure figure = make_figure("control_loops", {run_with_loops("run")});
  ASSERT_EQ(figure.panels.size(), 5u);
  EXPECT_EQ(figure.columns, 2);
  EXPECT_EQ(figure.panels[0].title, "Attitude PD: error");
  EXPECT_EQ(figure.panels[0].y.title, "Attitude error (rad)");
  ASSERT_EQ(figure.panels[0].curves.size(), 3u);
  EXPECT_EQ(figure.panels[0].curves[2].label, "z");
  ASSERT_EQ(figure.panels[1].curves.size(), 6u) << "commanded and delivered";
  EXPECT_EQ(figure.panels[1].y.title, "Torque (N m)");
  EXPECT_EQ(figure.panels[1].curves[0].y, (std::vector<double>{2, 2}));
  EXPECT_FALSE(figure.panels[1].curves[1].dash.empty());
  EXPECT_EQ(figure.panels[2].title, "Winch 1 to Winch 2: actual; dashed: set point");
  EXPECT_EQ(figure.panels[2].curves.size(), 4u);
  EXPECT_EQ(figure.panels[4].title, "Disturbance on target");
  const Figure own = make_figure("own_channels", {run_with_loops("run")});
  EXPECT_EQ(own.panels.size(), 2u) << "the disturbance and what no loop names";
}

TEST_F(PaperFigures, ControlLoopsOfSeveralRunsLieOverEachOther) {
  const Figure figure = make_figure("control_loops", {run_with_loops("with loop"), run_with_loops("without loop")});
  ASSERT_EQ(figure.panels.size(), 5u);
  ASSERT_EQ(figure.panels[0].curves.size(), 2u);
  EXPECT_EQ(figure.panels[0].title, "Attitude PD: size of the error");
  EXPECT_EQ(figure.panels[0].curves[0].y, (std::vector<double>{5, 5}));
  EXPECT_EQ(figure.panels[0].curves[0].label, "with loop");
  EXPECT_EQ(figure.panels[0].curves[1].label, "without loop");
}

TEST_F(PaperFigures, ComponentsOfOneQuantityShareAPanel) {
  RunSeries run;
  run.name = "run";
  run.begin(std::make_shared<const ChannelList>(std::vector<ChannelInfo>{{"time", "s", "time"},
                                                                         {"push_x", "N", "push"},
                                                                         {"push_y", "N", "push"},
                                                                         {"push_z", "N", "push"},
                                                                         {"spin_x", "rad/s", "spin"},
                                                                         {"mass", "kg", "mass"}}));
  for (const double t : {0.0, 1.0}) run.append({t, 1, 2, 3, 4, 5});
  const Figure figure = make_figure("own_channels", {run});
  ASSERT_EQ(figure.panels.size(), 3u);
  ASSERT_EQ(figure.panels[0].curves.size(), 3u);
  EXPECT_EQ(figure.panels[0].curves[2].label, "z");
  EXPECT_EQ(figure.panels[0].curves[2].y, (std::vector<double>{3, 3}));
  EXPECT_EQ(figure.panels[0].y.title, "Push (N)");
  EXPECT_EQ(figure.panels[1].y.title, "Spin x (rad/s)");
  EXPECT_TRUE(figure.panels[2].curves[0].label.empty());
  RunSeries other = run;
  other.name = "other";
  const Figure both = make_figure("own_channels", {run, other});
  ASSERT_EQ(both.panels[0].curves.size(), 6u);
  EXPECT_EQ(both.panels[0].curves[4].label, "other y");
  EXPECT_NE(both.panels[0].curves[4].dash, both.panels[0].curves[5].dash);
}

}  // namespace
}  // namespace netpocket
