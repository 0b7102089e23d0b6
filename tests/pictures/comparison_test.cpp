// The comparison with baselines fails when it should: each of these is a change that must be seen.

#include <gtest/gtest.h>

#include <algorithm>

#include "engine/state/pocket_groups.h"
#include "render/output/frame_renderer.h"
#include "render/scene/visible_points.h"
#include "tests/pictures/picture_comparison.h"
#include "tests/render/synthetic_pocket.h"

namespace netpocket::pictures {
namespace {

class Comparison : public testing::Test {
 protected:
  Comparison() {
    options_.width = 480;
    options_.height = 320;
    options_.scene.color_by = ColorBy::tension;
    options_.scene.color_range = ValueRange{0, 50};
    view_ = frame_view(CameraPreset::iso, visible_points(structure_, snapshot_), 1.5);
    baseline_ = draw(structure_, options_, view_);
  }

  Image draw(const Structure& structure, const FrameOptions& options, const CameraView& view) const {
    FrameRenderer renderer(make_gl_host(GlBackend::osmesa), structure, options);
    renderer.set_view(view);
    return renderer.render(snapshot_);
  }

  // Far enough beyond the bounds that no noise could hide it.
  void expect_caught(const Image& picture, double factor = 1.5) const {
    const auto difference = compare_pictures(picture, baseline_);
    EXPECT_FALSE(equal_enough(difference));
    EXPECT_GT(difference.beyond, factor * kLargestBeyond);
    RecordProperty("beyond", std::to_string(difference.beyond));
    RecordProperty("rmse", std::to_string(difference.rmse));
  }

  Structure structure_ = synthetic::make_structure();
  Snapshot snapshot_ = synthetic::make_snapshot(structure_, 5, 0.6);
  FrameOptions options_;
  CameraView view_;
  Image baseline_;
};

TEST_F(Comparison, PassesTheSamePicture) {
  const auto again = draw(structure_, options_, view_);
  const auto difference = compare_pictures(again, baseline_);
  EXPECT_TRUE(equal_enough(difference));
  EXPECT_EQ(difference.beyond, 0);
  EXPECT_EQ(difference.rmse, 0);
}

TEST_F(Comparison, CatchesAMissingRod) {
  options_.scene.color_by = ColorBy::none;  // colours go by element: they would all move
  baseline_ = draw(structure_, options_, view_);
  std::vector<std::int32_t> rods;
  for (std::size_t i = 0; i < structure_.threads.size(); ++i) {
    if (structure_.threads[i] == "rod") rods.push_back(static_cast<std::int32_t>(i));
  }
  ASSERT_EQ(rods.size(), 8u);
  for (const auto rod : rods) {
    auto without = structure_;
    const auto belongs = [&](const auto& e) { return e.group == index_of(PocketGroup::rods) && e.thread == rod; };
    std::erase_if(without.elements, belongs);
    expect_caught(draw(without, options_, view_));
  }
}

TEST_F(Comparison, CatchesAShiftedColorMap) {
  auto options = options_;
  options.scene.color_range = ValueRange{0, 55};  // 10 %
  expect_caught(draw(structure_, options, view_), 4);
  options = options_;
  options.scene.color_map = ColorMap::cividis;
  expect_caught(draw(structure_, options, view_), 4);
}

TEST_F(Comparison, CatchesACameraMovedByTwoPercent) {
  auto view = view_;
  view.position += 0.02 * (view.focal_point - view.position);  // closer
  expect_caught(draw(structure_, options_, view), 4);
  view = view_;
  const Eigen::Vector3d aside = 0.02 * (view.focal_point - view.position).norm() * Eigen::Vector3d::UnitX();
  view.position += aside;  // round the pocket
  expect_caught(draw(structure_, options_, view), 4);
}

TEST_F(Comparison, CatchesAMissingLabel) {
  auto options = options_;
  options.scene.time_label = false;
  expect_caught(draw(structure_, options, view_));
  options = options_;
  options.scene.scale_bar = false;
  expect_caught(draw(structure_, options, view_));
  options = options_;
  options.scene.axes = false;
  expect_caught(draw(structure_, options, view_));
}

TEST_F(Comparison, CatchesAnotherSizeAndBlankPictures) {
  auto options = options_;
  options.width = 482;
  EXPECT_FALSE(equal_enough(compare_pictures(draw(structure_, options, view_), baseline_)));
  EXPECT_FALSE(is_blank(baseline_));
  Image blank = baseline_;
  std::ranges::fill(blank.rgb, std::uint8_t{255});
  EXPECT_TRUE(is_blank(blank));
  blank.rgb[3000] = 0;
  EXPECT_TRUE(is_blank(blank));
}

TEST_F(Comparison, DifferencePictureShowsWhere) {
  auto other = baseline_;
  other.rgb[3 * (100 * 480 + 200)] ^= 0x80;
  const auto difference = difference_picture(other, baseline_);
  std::size_t marked = 0;
  for (std::size_t i = 0; i < difference.rgb.size(); i += 3) marked += difference.rgb[i + 1] < 255;
  EXPECT_EQ(marked, 1u);
  EXPECT_LT(difference.rgb[3 * (100 * 480 + 200) + 1], 160);
}

}  // namespace
}  // namespace netpocket::pictures
