// Target and spacecraft dragged in the view.

#include <QAction>
#include <QApplication>
#include <QMouseEvent>
#include <QTest>
#include <QUndoStack>

#include "gui/workbench/view_actions.h"
#include "gui/workbench/viewport/body_drag.h"
#include "gui/workbench/viewport/viewport.h"
#include "tests/gui/workbench/window_fixture.h"

namespace netpocket {
namespace {

const QSizeF kSize(800, 600);

// Looking along -z: right is +x, up is +y; 300 pixels are 10 m.
OrbitCamera side_camera() { return OrbitCamera({{0, 0, 50}, {0, 0, 0}, {0, 1, 0}, 30, 10}); }

TEST(BodyDrag, FollowsTheMouseInThePlaneOfThePicture) {
  const BodyDrag drag(side_camera(), kSize, {1, 2, 3}, {0.5, 2, -1});
  const QPointF grabbed = side_camera().project({1, 2, 3}, kSize)->position;
  const Eigen::Vector3d center = drag.center_at(grabbed + QPointF(60, -30), false);
  EXPECT_NEAR(center.x(), 2.5, 1e-9);
  EXPECT_NEAR(center.y(), 3, 1e-9);
  EXPECT_EQ(center.z(), -1);
}

TEST(BodyDrag, WithShiftMovesAlongOneAxis) {
  const BodyDrag drag(side_camera(), kSize, {0, 0, 0}, {0.123, 7.5, 0});
  const Eigen::Vector3d center = drag.center_at(QPointF(410, 300 + 90), true);
  EXPECT_EQ(center.x(), 0.123);  // untouched to the last digit
  EXPECT_NEAR(center.y(), 4.5, 1e-9);
}

TEST(BodyDrag, PerspectiveKeepsTheGrabbedPointUnderTheMouse) {
  const OrbitCamera camera({{20, 15, 25}, {0, 5, 0}, {0, 1, 0}, 35, 0});
  const Eigen::Vector3d grabbed(1, 6, 2);
  const QPointF mouse = camera.project(grabbed, kSize)->position + QPointF(120, 75);
  const Eigen::Vector3d center = BodyDrag(camera, kSize, grabbed, grabbed).center_at(mouse, false);
  const auto seen = camera.project(center, kSize);
  ASSERT_TRUE(seen);
  // Positions are whole centimetres: less than a pixel at this distance.
  EXPECT_NEAR(seen->position.x(), mouse.x(), 0.5);
  EXPECT_NEAR(seen->position.y(), mouse.y(), 0.5);
}

class PlacementTest : public WindowTest {
 protected:
  PlacementTest() {
    EXPECT_TRUE(wait_until([&] { return window_->viewport().state().structure != nullptr; }));
    window_->viewport().set_preset(CameraPreset::front);
    EXPECT_TRUE(wait_for_picture());
  }

  // Where the target is seen through the mouth.
  QPoint target() const {
    auto& viewport = window_->viewport();
    const auto& state = viewport.state();
    return OrbitCamera(state.camera).project(state.snapshot->bodies[1].position, viewport.size())->position.toPoint();
  }

  void drag(const QPoint& from, const QPoint& way, Qt::KeyboardModifiers modifiers = {}) const {
    auto& viewport = window_->viewport();
    QTest::mousePress(&viewport, Qt::LeftButton, {}, from);
    for (int i = 1; i <= 5; ++i) {
      const QPointF to = from + way * i / 5;
      QMouseEvent move(QEvent::MouseMove, to, viewport.mapToGlobal(to), Qt::NoButton, Qt::LeftButton, modifiers);
      QApplication::sendEvent(&viewport, &move);
      QTest::qWait(5);
    }
    QTest::mouseRelease(&viewport, Qt::LeftButton, modifiers, from + way);
  }
};

TEST_F(PlacementTest, DragOfTheTargetIsOneEditOfTheScenario) {
  window_->view_actions().move_action()->trigger();
  const Eigen::Vector3d before = window_->document().scenario().target.position;
  drag(target(), {30, 0});
  const Eigen::Vector3d after = window_->document().scenario().target.position;
  EXPECT_GT((after - before).norm(), 0.2);
  EXPECT_EQ(after.y(), before.y());  // along the axis one looks: unchanged
  // The picture shows the target there, and one step back undoes the whole drag.
  ASSERT_TRUE(wait_until([&] { return window_->viewport().state().snapshot->bodies[1].position.isApprox(after); }));
  EXPECT_EQ(window_->document().undo_stack()->count(), 1);
  screenshot("moving");
  window_->document().undo_stack()->undo();
  EXPECT_EQ(window_->document().scenario().target.position, before);
}

// From the side the net is before the target.
TEST_F(PlacementTest, TheNetIsNotInTheWay) {
  window_->viewport().set_preset(CameraPreset::side);
  ASSERT_TRUE(wait_for_picture());
  window_->view_actions().move_action()->trigger();
  const Eigen::Vector3d before = window_->document().scenario().target.position;
  for (int i = 0; i < 5; ++i) drag(target() + QPoint(3 * i, 2 * i), {0, 20}, Qt::ShiftModifier);
  EXPECT_EQ(window_->document().undo_stack()->count(), 5);
  EXPECT_NE(window_->document().scenario().target.position, before);
}

TEST_F(PlacementTest, WithoutTheToolADragOrbits) {
  const Eigen::Vector3d camera = window_->viewport().view().position;
  drag(target(), {40, 0});
  EXPECT_EQ(window_->document().undo_stack()->count(), 0);
  EXPECT_GT((window_->viewport().view().position - camera).norm(), 0.1);
}

TEST_F(PlacementTest, RecordedMomentsAreNotMoved) {
  ASSERT_TRUE(run_to(0.2));
  window_->view_actions().move_action()->trigger();
  ASSERT_TRUE(wait_until([&] { return window_->viewport().state().snapshot->bodies[1].velocity.norm() == 0; }));
  EXPECT_TRUE(window_->view_actions().move_action()->isChecked());
  window_->session().show_time(0.1);
  EXPECT_FALSE(window_->view_actions().move_action()->isChecked());
}

}  // namespace
}  // namespace netpocket
