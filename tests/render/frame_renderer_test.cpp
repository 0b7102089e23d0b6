#include "render/output/frame_renderer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "engine/state/pocket_groups.h"
#include "render/output/png_file.h"
#include "render/render_error.h"
#include "render/scene/visible_points.h"
#include "tests/render/picture_checks.h"
#include "tests/render/synthetic_pocket.h"

namespace netpocket {
namespace {

class FrameRendererTest : public testing::Test {
 protected:
  static FrameOptions small() {
    FrameOptions options;
    options.width = 480;
    options.height = 270;
    return options;
  }

  std::unique_ptr<FrameRenderer> make(const FrameOptions& options, CameraPreset camera = CameraPreset::iso) const {
    auto renderer = std::make_unique<FrameRenderer>(make_gl_host(GlBackend::osmesa), structure_, options);
    renderer->set_view(frame_view(camera, visible_points(structure_, open_), renderer->aspect()));
    return renderer;
  }

  Image render(const FrameOptions& options, const Snapshot& snapshot, CameraPreset camera = CameraPreset::iso) const {
    return make(options, camera)->render(snapshot);
  }

  Structure structure_ = synthetic::make_structure();
  Snapshot open_ = synthetic::make_snapshot(structure_, 0, 0);
};

TEST_F(FrameRendererTest, EveryCameraShowsSomethingOnBothBackgrounds) {
  const auto folder = pictures::folder("cameras");
  const std::pair<const char*, CameraPreset> presets[] = {{"iso", CameraPreset::iso},
                                                          {"side", CameraPreset::side},
                                                          {"front", CameraPreset::front},
                                                          {"mouth", CameraPreset::mouth}};
  for (const auto background : {Background::white, Background::space}) {
    for (const auto& [name, preset] : presets) {
      auto options = small();
      options.scene.background = background;
      const auto image = render(options, open_, preset);
      write_png(image, folder + "/" + name + (background == Background::white ? "_white.png" : "_space.png"));
      EXPECT_GT(pictures::drawn_fraction(image), 0.1) << name;
      EXPECT_LT(pictures::drawn_fraction(image), 0.9) << name;
    }
  }
}

// The closing ropes are the only things of their colour.
TEST_F(FrameRendererTest, ShowsTheClosingRopes) {
  auto options = small();
  options.scene.axes = false;
  const auto with = render(options, open_);
  EXPECT_GT(pictures::count_color(with, 214, 94, 0, 40), 60u);
  auto without = structure_;
  std::erase_if(without.elements,
                [](const auto& element) { return element.group == index_of(PocketGroup::closing_ropes); });
  FrameRenderer renderer(make_gl_host(GlBackend::osmesa), without, options);
  renderer.set_view(frame_view(CameraPreset::iso, visible_points(structure_, open_), renderer.aspect()));
  EXPECT_LT(pictures::count_color(renderer.render(open_), 214, 94, 0, 40), 10u);
}

TEST_F(FrameRendererTest, UpdatesInPlace) {
  auto renderer = make(small());
  const auto first = renderer->render(open_);
  const auto closed = renderer->render(synthetic::make_snapshot(structure_, 10, 1));
  EXPECT_GT(pictures::differing_fraction(first, closed, 8), 0.05);
  EXPECT_EQ(renderer->render(open_).rgb, first.rgb);
}

// A picture twice as large, halved, is the same picture: framing, lines and labels keep their share of it. Lines have
// edges elsewhere within a pixel, texts are hinted for their size: so a large tolerance, but on few pixels.
TEST_F(FrameRendererTest, LooksTheSameAtAnyResolution) {
  auto options = small();
  options.width = 960;
  options.height = 540;
  options.supersampling = 2;
  const auto image = render(options, open_);
  options.width *= 2;
  options.height *= 2;
  auto renderer = make(options);
  auto drawn = renderer->draw(open_);
  drawn.width /= 2;
  drawn.height /= 2;
  drawn.supersampling *= 2;
  const auto halved = smooth_frame(drawn);
  write_png(image, pictures::folder("resolution") + "/drawn.png");
  write_png(halved, pictures::folder("resolution") + "/halved.png");
  EXPECT_LT(pictures::differing_fraction(image, halved, 64), 0.01);
}

TEST_F(FrameRendererTest, ColoursByEachQuantity) {
  const auto folder = pictures::folder("colors");
  auto options = small();
  const auto plain = render(options, open_);
  for (const auto& [name, color_by] : {std::pair{"tension", ColorBy::tension}, std::pair{"strain", ColorBy::strain},
                                       std::pair{"speed", ColorBy::speed}}) {
    options.scene.color_by = color_by;
    const auto image = render(options, open_);
    write_png(image, folder + "/" + name + ".png");
    EXPECT_GT(pictures::differing_fraction(plain, image, 20), 0.02) << name;
  }
}

TEST_F(FrameRendererTest, TurnedTargetsLookDifferent) {
  for (const Shape& shape : {Shape(Sphere{4.5}), Shape(Box{{5, 6, 5}}), Shape(Cylinder{3, 7})}) {
    const auto structure = synthetic::make_structure(shape);
    FrameRenderer renderer(make_gl_host(GlBackend::osmesa), structure, small());
    renderer.set_view(frame_view(CameraPreset::iso, visible_points(structure, open_), renderer.aspect()));
    auto snapshot = open_;
    snapshot.bodies[1].attitude = Eigen::Quaterniond::Identity();
    const auto still = renderer.render(snapshot);
    // Half a panel about the axis of symmetry, which a plain surface would hide.
    snapshot.bodies[1].attitude = Eigen::AngleAxisd(0.26, Eigen::Vector3d::UnitY());
    EXPECT_GT(pictures::differing_fraction(still, renderer.render(snapshot), 4), 0.03);
  }
}

// FXAA only softens edges; with multisampling on it would draw black.
TEST_F(FrameRendererTest, FastSmoothingSoftensEdgesOnly) {
  auto options = small();
  options.supersampling = 1;
  const auto jagged = render(options, open_);
  options.scene.fast_smoothing = true;
  const auto smooth = render(options, open_);
  EXPECT_GT(pictures::differing_fraction(jagged, smooth, 4), 0.01);
  EXPECT_LT(pictures::differing_fraction(jagged, smooth, 64), 0.08);
}

// A line thinner than a pixel can fall between the centres of pixels.
TEST_F(FrameRendererTest, TheScaleBarOfASmallPictureIsWhole) {
  auto options = small();
  options.supersampling = 1;
  for (const int height : {200, 230, 270, 320, 350}) {
    options.height = height;
    const auto image = render(options, open_);
    const double unit = height / 720.0;
    const int right = image.width - static_cast<int>(40 * unit), left = right - static_cast<int>(40 * unit);
    const int middle = height - static_cast<int>(36 * unit);
    for (int x = left; x < right; ++x) {
      int darkest = 255;
      for (int y = middle - 2; y <= middle + 2; ++y)
        darkest = std::min<int>(darkest, image.rgb[3 * (y * image.width + x)]);
      EXPECT_LT(darkest, 128) << height << " pixels high, at " << x;
    }
  }
}

TEST_F(FrameRendererTest, RefusesImpossibleSizes) {
  auto options = small();
  options.width = 8;
  EXPECT_THROW(make(options), RenderError);
  options.width = 16000;
  EXPECT_THROW(make(options), RenderError);  // times two for smoothing
  options = small();
  options.supersampling = 0;
  EXPECT_THROW(make(options), RenderError);
}

}  // namespace
}  // namespace netpocket
