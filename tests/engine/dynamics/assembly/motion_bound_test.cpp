// The bound of all points' motion against the motion of points of the curves.

#include "engine/dynamics/assembly/motion_bound.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "engine/ancf/shape_functions.h"

namespace netpocket {
namespace {

// A chain of elements of unequal length, moved at random.
class MotionBoundTest : public testing::Test {
 protected:
  MotionBoundTest() : before_(0), now_(0) {
    model_.materials.push_back({});
    for (int i = 0; i <= kElements; ++i) {
      model_.add_node(Eigen::Vector3d(i, 0, 0));
      model_.add_gradient(0, Eigen::Vector3d(1, 0, 0));
    }
    for (std::int32_t i = 0; i < kElements; ++i) model_.add_element({i, i, i + 1, i + 1, 0.5 + 0.1 * (i % 7), 0});
    layout_ = {static_cast<std::int32_t>(model_.nodes.size()), static_cast<std::int32_t>(model_.gradients.size())};
    before_ = now_ = CoordinateVectors(layout_.size());
    for (std::int32_t i = 0; i <= kElements; ++i) {
      for (const std::int32_t coordinate : {layout_.position(i), layout_.gradient(i)}) {
        before_.set(coordinate, random());
        now_.set(coordinate, before_.get(coordinate) + 0.1 * random());
      }
    }
  }

  Eigen::Vector3d random() { return {uniform_(random_), uniform_(random_), uniform_(random_)}; }

  Eigen::Vector3d point(const CoordinateVectors& state, std::int32_t element, double xi) const {
    const ModelElement& e = model_.elements[static_cast<std::size_t>(element)];
    const NodalWeights weights = shape(xi, e.length);
    return weights[0] * state.get(layout_.position(e.node1)) + weights[1] * state.get(layout_.gradient(e.gradient1)) +
           weights[2] * state.get(layout_.position(e.node2)) + weights[3] * state.get(layout_.gradient(e.gradient2));
  }

  static constexpr std::int32_t kElements = 2500;  // more than a range of a shared loop
  std::mt19937 random_{3};
  std::uniform_real_distribution<double> uniform_{-1, 1};
  Model model_;
  CoordinateLayout layout_;
  CoordinateVectors before_, now_;
};

TEST_F(MotionBoundTest, NoPointMovesFarther) {
  double farthest = 0;
  for (std::int32_t element = 0; element < kElements; ++element) {
    for (double xi = -1; xi <= 1; xi += 0.125) {
      farthest = std::max(farthest, (point(now_, element, xi) - point(before_, element, xi)).norm());
    }
  }
  const double bound = MotionBound(model_).way(before_, now_);
  EXPECT_GE(bound, farthest);
  EXPECT_LE(bound, 2 * farthest) << "nor is it far off";
}

TEST_F(MotionBoundTest, SpeedIsThatOfTheSameMotion) {
  CoordinateVectors velocities(layout_.size());
  for (std::int32_t coordinate = 0; coordinate < layout_.size(); ++coordinate)
    velocities.set(coordinate, now_.get(coordinate) - before_.get(coordinate));
  const MotionBound bound(model_);
  EXPECT_EQ(bound.speed(velocities), bound.way(before_, now_));
}

TEST_F(MotionBoundTest, SeesWhatIsNotANumber) {
  const MotionBound bound(model_);
  for (const std::int32_t coordinate : {layout_.position(0), layout_.position(kElements), layout_.gradient(17)}) {
    CoordinateVectors lost = now_;
    lost.set(coordinate, {0, std::numeric_limits<double>::quiet_NaN(), 0});
    EXPECT_TRUE(std::isnan(bound.way(before_, lost)));
    EXPECT_TRUE(std::isnan(bound.speed(lost)));
  }
}

TEST(MotionBound, NothingDoesNotMove) {
  const Model nothing;
  EXPECT_EQ(MotionBound(nothing).speed(CoordinateVectors(0)), 0);
}

}  // namespace
}  // namespace netpocket
