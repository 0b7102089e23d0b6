#include "gui/workbench/viewport/picker.h"

#include <gtest/gtest.h>

#include "engine/state/pocket_groups.h"
#include "gui/workbench/simulation/pocket_preview.h"
#include "gui/workbench/viewport/pick_description.h"
#include "render/scene/visible_points.h"

namespace netpocket {
namespace {

const QSizeF kSize(900, 700);

ViewState default_view(CameraPreset preset) {
  const PocketPreview pocket = preview_pocket(Scenario{});
  ViewState state{pocket.structure, pocket.snapshot, std::make_shared<const SceneOptions>(), {}, {}};
  state.camera = frame_view(preset, visible_points(*state.structure, *state.snapshot), kSize.width() / kSize.height());
  return state;
}

QPointF on_screen(const ViewState& state, const Eigen::Vector3d& point) {
  return OrbitCamera(state.camera).project(point, kSize)->position;
}

TEST(Picker, FindsTheNodeUnderTheMouse) {
  const ViewState state = default_view(CameraPreset::front);
  const std::int32_t tip = state.structure->nodes(kRodTips)[1];
  const auto pick = pick_at(state, on_screen(state, state.snapshot->positions.col(tip)) + QPointF(2, 1), kSize);
  ASSERT_TRUE(pick);
  EXPECT_EQ(pick->kind, PickKind::node);
  EXPECT_EQ(pick->index, tip);
}

TEST(Picker, FindsTheRodUnderTheMouse) {
  const ViewState state = default_view(CameraPreset::side);
  for (std::size_t i = 0; i < state.structure->elements.size(); ++i) {
    const auto& element = state.structure->elements[i];
    if (element.group != index_of(PocketGroup::rods)) continue;
    const Pick middle{PickKind::element, static_cast<std::int32_t>(i), 0.5, {0, 0, 0}};
    const auto where = position_of(middle, *state.structure, *state.snapshot);
    const auto pick = pick_at(state, on_screen(state, *where), kSize);
    ASSERT_TRUE(pick);
    // Something in front of it may be what is seen; then it is nearer.
    const auto found = position_of(*pick, *state.structure, *state.snapshot);
    const Eigen::Vector3d forward = (state.camera.focal_point - state.camera.position).normalized();
    EXPECT_LE((*found - *where).dot(forward), 0.2);
  }
}

TEST(Picker, FindsTheTargetThroughTheMouthButNotACordBehindIt) {
  const ViewState state = default_view(CameraPreset::front);
  const auto pick = pick_at(state, on_screen(state, state.snapshot->bodies[1].position), kSize);
  ASSERT_TRUE(pick);
  ASSERT_EQ(pick->kind, PickKind::body);
  EXPECT_EQ(state.structure->bodies[static_cast<std::size_t>(pick->index)].role, BodyRole::target);
  // The sphere's nearest point to a viewer on the axis: 4.5 m before its centre (the default radius), to the tracing's
  // tolerance.
  EXPECT_NEAR(pick->local.norm(), 4.5, 1e-3);
}

TEST(Picker, FindsNothingInTheVoid) {
  const ViewState state = default_view(CameraPreset::iso);
  EXPECT_FALSE(pick_at(state, {3, 3}, kSize));
  EXPECT_FALSE(pick_at(ViewState{}, {3, 3}, kSize));
}

TEST(Picker, DescribesWhatWasPicked) {
  const ViewState state = default_view(CameraPreset::front);
  const auto body = describe_pick({PickKind::body, 1, 0, {0, 0, 0}}, *state.structure, *state.snapshot);
  EXPECT_EQ(body.title, "target");
  EXPECT_EQ(body.rows.front().value, "0.000, 7.500, 0.000 m");  // the default place
  const auto node = describe_pick({PickKind::node, state.structure->nodes(kRodTips)[0], 0, {0, 0, 0}}, *state.structure,
                                  *state.snapshot);
  EXPECT_TRUE(node.detail.contains("rod")) << node.detail.toStdString();
}

// A spacecraft of more than a tonne moves by millimetres a second.
TEST(Picker, TellsSmallVelocities) {
  const ViewState state = default_view(CameraPreset::front);
  Snapshot snapshot = *state.snapshot;
  snapshot.bodies[0].velocity = {1e-9, -0.0019834, 2e-5};
  snapshot.bodies[0].angular_velocity = {0, 1e-12, 0};
  const auto body = describe_pick({PickKind::body, 0, 0, {0, 0, 0}}, *state.structure, snapshot);
  EXPECT_EQ(body.rows[1].value, "0.00000, -0.00198, 0.00002 m/s");
  EXPECT_EQ(body.rows[2].value, "0.000, 0.000, 0.000 rad/s");
}

}  // namespace
}  // namespace netpocket
