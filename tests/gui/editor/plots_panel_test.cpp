#include "gui/workbench/panels/plots_panel.h"

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "temporary_document.h"
#include "tests/gui/patience.h"
#include "tests/render/figures/synthetic_run.h"

namespace netpocket {
namespace {

class Plots : public testing::Test {
 protected:
  Plots() {
    panel.resize(700, 420);
    panel.show();
  }
  void settle() {
    const bool expected = !panel.series().empty();
    EXPECT_TRUE(wait_patiently([&] { return time_range(panel.chart()->figure()).has_value() == expected; }));
    panel.grab();
  }

  PlotsPanel panel;
};

TEST_F(Plots, ClickGoesToATime) {
  panel.set_series({synthetic_run("case1", 10)});
  settle();
  QSignalSpy clicked(&panel, &PlotsPanel::time_clicked);
  QTest::mouseClick(panel.chart(), Qt::LeftButton, {}, panel.chart()->point_at(12.0)->toPoint());
  ASSERT_EQ(clicked.size(), 1);
  EXPECT_NEAR(clicked[0][0].toDouble(), 12, 0.1);
}

TEST_F(Plots, ShowsTheValuesAtTheCursor) {
  panel.set_series({synthetic_run("case1", 10)});
  settle();
  panel.set_time(15.0);
  EXPECT_TRUE(panel.values_text().contains("commanded")) << panel.values_text().toStdString();
  EXPECT_TRUE(panel.values_text().contains("<b>2.1</b>")) << "the closed length: " << panel.values_text().toStdString();
}

TEST_F(Plots, EveryFigureDrawsOneOrSeveralRuns) {
  for (const auto& runs : {std::vector<RunSeries>{},
                           {synthetic_run("case1", 10)},
                           {synthetic_run("case1", 10), synthetic_run("case2", 7.5), synthetic_run("case3", 5)}}) {
    panel.set_series(runs);
    settle();
    for (const char* name : {"figure03_closing", "figure05_force", "figure06_position", "figure10_target_position",
                             "figure11_spacecraft_position", "energy", "tension"}) {
      panel.show_figure(name);
      EXPECT_EQ(panel.figure_name(), name);
      panel.grab();
      EXPECT_EQ(time_range(panel.chart()->figure()).has_value(), !runs.empty());
    }
  }
}

TEST_F(Plots, GrowsFrameByFrame) {
  const RunSeries whole = synthetic_run("case1", 10);
  RunSeries start;
  start.name = "case1";
  panel.set_series({start});
  for (std::size_t i = 0; i < 100; ++i) {
    std::vector<double> frame(whole.channels.size());
    for (std::size_t c = 0; c < frame.size(); ++c) frame[c] = whole.channels[c].empty() ? 0 : whole.channels[c][i];
    panel.append(0, frame);
  }
  settle();
  EXPECT_NEAR(time_range(panel.chart()->figure())->end, whole.times()[99], 1e-12);
}

TEST_F(Plots, PickedItemsAreAFigureOfTheirOwn) {
  Panel picked;
  picked.title = "Rod 3, element 2";
  picked.curves.emplace_back();
  picked.curves[0].x = {0, 1};
  picked.curves[0].y = {0, 1};
  panel.set_picked({picked});
  panel.show_figure("picked");
  EXPECT_EQ(panel.chart()->figure().panels.size(), 1u);
  panel.set_picked({});
  EXPECT_NE(panel.figure_name(), "picked");
}

TEST_F(Plots, ExportsWhatIsShown) {
  panel.set_series({synthetic_run("case1", 10)});
  settle();
  QTemporaryDir folder;
  for (const char* name : {"a.png", "a.svg", "a.pdf", "a.csv"}) {
    EXPECT_FALSE(panel.export_figure(folder.filePath(name)));
    EXPECT_GT(read_file(folder.filePath(name)).size(), 1000) << name;
  }
  EXPECT_TRUE(panel.export_figure(folder.filePath("no/such.png")));
}

}  // namespace
}  // namespace netpocket
