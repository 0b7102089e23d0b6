#include "gui/workbench/second_view.h"

#include <QAction>
#include <QTest>

#include "gui/workbench/run_actions.h"
#include "gui/workbench/timeline/timeline_bar.h"
#include "gui/workbench/view_actions.h"
#include "tests/gui/workbench/window_fixture.h"

namespace netpocket {
namespace {

class SecondViewTest : public WindowTest {
 protected:
  SecondView& open() const {
    window_->view_actions().second_view_action()->trigger();
    return *window_->second_view();
  }
};

TEST_F(SecondViewTest, IsNotThereUntilWanted) {
  EXPECT_EQ(window_->second_view(), nullptr);
  open();
  ASSERT_NE(window_->second_view(), nullptr);
  EXPECT_TRUE(window_->second_view()->isVisible());
  window_->view_actions().second_view_action()->trigger();
  EXPECT_FALSE(window_->second_view()->isVisible());
}

TEST_F(SecondViewTest, ShowsTheSameMomentFromElsewhere) {
  ASSERT_TRUE(run_to(0.4));
  SecondView& second = open();
  second.viewport().set_preset(CameraPreset::front);
  window_->timeline().go_to(0.2);
  ASSERT_TRUE(wait_until([&] { return !second.viewport().picture().isNull(); }));
  EXPECT_EQ(second.viewport().state().snapshot, window_->viewport().state().snapshot);
  EXPECT_GT((second.viewport().view().position - window_->viewport().view().position).norm(), 1);
  screenshot("second_view");
}

TEST_F(SecondViewTest, ShowsAnotherRunAtTheSameTime) {
  ASSERT_TRUE(run_to(0.6));
  const RunId first = window_->session().current()->id;
  window_->timeline().go_to(0.3);
  ASSERT_FALSE(window_->document().set_value(*find_parameter("closing.duration"), 3.0));
  window_->run_actions().branch();
  window_->session().resume({.until = 0.6});
  ASSERT_TRUE(wait_until([&] { return window_->session().current()->end_time() >= 0.6 - 1e-6; }));
  SecondView& second = open();
  second.choose_run(first);
  // Frames that are no longer in memory are read.
  window_->session().runs().set_cache_bytes(1);
  for (const double time : {0.5, 0.1, 0.4}) {
    window_->timeline().go_to(time);
    ASSERT_TRUE(wait_until([&] {
      const auto& here = window_->viewport().state().snapshot;
      const auto& there = second.viewport().state().snapshot;
      return there && std::abs(here->time - time) < 0.011 && std::abs(there->time - time) < 0.011;
    })) << time;
  }
  EXPECT_EQ(second.viewport().state().structure, window_->session().runs().find(first)->structure);
  // When its run goes, the shown one takes its place.
  window_->session().remove_run(first);
  EXPECT_EQ(second.run(), window_->session().current()->id);
}

TEST_F(SecondViewTest, LinkedCamerasMoveTogether) {
  SecondView& second = open();
  ASSERT_TRUE(wait_until([&] { return window_->viewport().state().structure != nullptr; }));
  second.link_cameras(true);
  window_->viewport().set_preset(CameraPreset::mouth);
  EXPECT_EQ(second.viewport().view().position, window_->viewport().view().position);
  QTest::keyClick(&second.viewport(), Qt::Key_Left);
  EXPECT_EQ(second.viewport().view().position, window_->viewport().view().position);
  second.link_cameras(false);
  QTest::keyClick(&second.viewport(), Qt::Key_Left);
  EXPECT_NE(second.viewport().view().position, window_->viewport().view().position);
}

}  // namespace
}  // namespace netpocket
