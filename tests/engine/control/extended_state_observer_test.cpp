// Extended state observer: poles, the bound of its error and the steady error of a ramp.

#include "engine/control/extended_state_observer.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/control/random_numbers.h"

namespace netpocket {
namespace {

using Eigen::Vector3d;

constexpr double kObserverPeriod = 0.01;  // s

// Follows v' = a + d exactly for a disturbance that is linear over a period; a is known and switches.
class Plant {
 public:
  explicit Plant(double bandwidth) : observer(bandwidth) {
    observer.update(velocity_, Vector3d::Zero(), kObserverPeriod);
  }

  void step(const Vector3d& slope) {
    const Vector3d known = (++steps_ / 50 % 2 == 0 ? 1.0 : -1.0) * Vector3d(3, -2, 1);
    velocity_ += kObserverPeriod * (known + disturbance + 0.5 * kObserverPeriod * slope);
    disturbance += kObserverPeriod * slope;
    observer.update(velocity_, known, kObserverPeriod);
  }
  Vector3d error() const { return disturbance - observer.disturbance(); }

  ExtendedStateObserver observer;
  Vector3d disturbance = Vector3d::Zero();

 private:
  Vector3d velocity_ = Vector3d(1, 2, 3);
  int steps_ = 0;
};

// |d'| <= r bounds the error by 2 r/w: here d' switches at random between -r and r.
TEST(ExtendedStateObserver, ErrorIsBoundedByTheBandwidth) {
  constexpr double kSteepest = 0.7;
  for (const double bandwidth : {2.0, 10.0, 50.0}) {
    Plant plant(bandwidth);
    RandomNumbers random(5);
    Vector3d slope = Vector3d::Constant(kSteepest);
    double largest = 0;
    for (int i = 0; i < 20'000; ++i) {
      for (double& component : slope) component *= random.uniform() < 0.005 ? -1 : 1;
      plant.step(slope);
      largest = std::max(largest, plant.error().cwiseAbs().maxCoeff());
    }
    EXPECT_LE(largest, 2 * kSteepest / bandwidth) << bandwidth;
    EXPECT_GT(largest, 0.7 * 2 * kSteepest / bandwidth) << bandwidth;  // the bound is tight
  }
}

// A ramp leaves r dt ((1 + b)/(1 - b) - 1/2), b = exp(-w dt).
TEST(ExtendedStateObserver, RampLeavesThePredictedError) {
  const Vector3d slope(0.3, -0.2, 1);
  Plant plant(10);
  for (int i = 0; i < 2000; ++i) plant.step(slope);
  const double b = std::exp(-10 * kObserverPeriod);
  EXPECT_NEAR((plant.error() - kObserverPeriod * ((1 + b) / (1 - b) - 0.5) * slope).norm(), 0, 1e-11);
  EXPECT_NEAR(plant.error().z(), 2.0 / 10, 0.03);
}

// A jump of the disturbance decays as (1 + w t) exp(-w t), by the two equal poles.
TEST(ExtendedStateObserver, JumpDecaysWithTwoEqualPoles) {
  Plant plant(2);
  plant.disturbance = {1, 0, 0};
  for (int i = 1; i <= 300; ++i) {
    plant.step(Vector3d::Zero());
    const double wt = 2 * kObserverPeriod * i;
    EXPECT_NEAR(plant.error().x(), (1 + wt) * std::exp(-wt), 0.02) << i;
  }
}

}  // namespace
}  // namespace netpocket
