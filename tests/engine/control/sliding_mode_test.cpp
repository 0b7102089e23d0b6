// Sliding mode: reaching time, decay in the layer, what a disturbance leaves, observer and feed-forward.

#include "engine/control/sliding_mode.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/control/double_loop.h"
#include "engine/control/sliding_mode_control.h"
#include "tests/engine/control/single_axis.h"

namespace netpocket {
namespace {

using Eigen::Vector3d;
using test::about_axis;
using test::SingleAxis;

constexpr double kFinePeriod = 1e-4;  // s
const SlidingModeGains kSlidingGains = {.slope = 0.5, .reaching = 0.8, .switching = 0.05, .layer = 0.002};

double sliding_variable(const SingleAxis& body) { return body.rate + kSlidingGains.slope * body.angle; }

TEST(SlidingMode, SaturationIsTheSignWithoutALayer) {
  EXPECT_EQ(saturation(Vector3d(0.5, -3, 0), 1), Vector3d(0.5, -1, 0));
  EXPECT_EQ(saturation(Vector3d(0.5, -3, 0), 0), Vector3d(1, -1, 0));
}

// s' = -k s - h from s0: the layer is reached after ln((k s0 + h)/(k phi + h))/k. Tolerance: the period.
TEST(SlidingMode, ReachesItsLayerInThePredictedTime) {
  for (const double reaching : {0.8, 1e-9}) {
    SlidingModeGains gains = kSlidingGains;
    gains.reaching = reaching;
    AttitudeSlidingMode control(gains, 0, SingleAxis::inertia());
    SingleAxis body = {0.9, 0.1};
    const double s0 = sliding_variable(body);
    const double predicted =
        std::log1p(reaching * (s0 - gains.layer) / (reaching * gains.layer + gains.switching)) / reaching;
    double time = 0;
    while (sliding_variable(body) > gains.layer && time < 100) {
      body.turn(about_axis(control.update(body.body(), {SingleAxis::wanted()}, Vector3d::Zero(), kFinePeriod).torque),
                kFinePeriod);
      time += kFinePeriod;
    }
    EXPECT_NEAR(time, predicted, 2 * kFinePeriod) << reaching;
  }
}

// Once on the surface, e' = -c e.
TEST(SlidingMode, ErrorDecaysWithTheSlope) {
  AttitudeSlidingMode control(kSlidingGains, 0, SingleAxis::inertia());
  SingleAxis body = {0.4, -kSlidingGains.slope * 0.4};
  for (int i = 0; i < 40'000; ++i) {
    body.turn(about_axis(control.update(body.body(), {SingleAxis::wanted()}, Vector3d::Zero(), kFinePeriod).torque),
              kFinePeriod);
  }
  EXPECT_NEAR(body.angle, 0.4 * std::exp(-kSlidingGains.slope * 4), 1e-5);
}

struct Aims {
  double observer = 0;  // rad/s
  double known = 0;     // part of the disturbing torque that the feed-forward knows
};

// The body after 40 s at rest under a steady disturbing torque (N m).
SingleAxis disturbed(const Aims& aims, double torque) {
  constexpr double kCoarse = 1e-3;
  AttitudeSlidingMode control(kSlidingGains, aims.observer, SingleAxis::inertia());
  SingleAxis body;
  for (int i = 0; i < 40'000; ++i) {
    const Vector3d contact = aims.known * torque * SingleAxis::world_axis();
    const Wrench demand = control.update(body.body(), {SingleAxis::wanted()}, contact, kCoarse);
    body.turn(about_axis(demand.torque) + torque, kCoarse);
  }
  return body;
}

// In the layer 0 = -(k + h/phi) s + d0, and then e = s/c.
TEST(SlidingMode, SteadyTorqueLeavesThePredictedError) {
  const double torque = 200, s = torque / SingleAxis::moment() /
                                 (kSlidingGains.reaching + kSlidingGains.switching / kSlidingGains.layer);
  EXPECT_NEAR(disturbed({}, torque).angle, s / kSlidingGains.slope, 1e-9);
  // Feed-forward that knows 90 % leaves 10 %.
  EXPECT_NEAR(disturbed({.known = 0.9}, torque).angle, 0.1 * s / kSlidingGains.slope, 1e-9);
  // The observer estimates all of it, or what the feed-forward misses.
  EXPECT_NEAR(disturbed({.observer = 5}, torque).angle, 0, 1e-9);
  EXPECT_NEAR(disturbed({.observer = 5, .known = 0.9}, torque).angle, 0, 1e-9);
}

TEST(SlidingMode, ObserverEstimatesTheTorqueThatIsNotKnown) {
  AttitudeSlidingMode control(kSlidingGains, 5, SingleAxis::inertia());
  SingleAxis body;
  for (int i = 0; i < 5000; ++i) {
    const Wrench demand = control.update(body.body(), {SingleAxis::wanted()}, 150 * SingleAxis::world_axis(), 1e-3);
    body.turn(about_axis(demand.torque) + 200, 1e-3);
  }
  EXPECT_NEAR((control.disturbance() - Vector3d(0, 50, 0)).norm(), 0, 1e-6);  // body axes
}

// Euler's equations: on the wanted motion both kinds of control exert w x (J w) + J a and no more.
TEST(SlidingMode, KeepsAWantedSpinAboutAnyAxis) {
  BodyState state;
  state.angular_velocity = {0.1, 0.2, -0.3};
  const WantedMotion wanted = {state, Vector3d::Zero(), {0.01, 0, 0.02}};
  const Vector3d by_hand = {0.2 * -0.3 * (14498 - 12736) + 4282 * 0.01, -0.3 * 0.1 * (4282 - 14498),
                            0.1 * 0.2 * (12736 - 4282) + 14498 * 0.02};
  AttitudeSlidingMode single(kSlidingGains, 5, SingleAxis::inertia());
  EXPECT_NEAR((single.update(state, wanted, Vector3d::Zero(), 0.1).torque - by_hand).norm(), 0, 1e-11);
  DoubleLoop loops({.slope = 1, .inner = kSlidingGains, .observer_bandwidth = 5}, SingleAxis::inertia());
  EXPECT_NEAR((loops.update(state, wanted, 0.1).torque - by_hand).norm(), 0, 1e-11);
}

// An actuator that exerts nothing: told so, the observer does not take the missing torque for a disturbance.
TEST(SlidingMode, ObserverHeedsWhatWasDelivered) {
  AttitudeSlidingMode told(kSlidingGains, 5, SingleAxis::inertia()), untold = told;
  const SingleAxis body = {0.1, 0};
  for (int i = 0; i < 5000; ++i) {
    told.update(body.body(), {SingleAxis::wanted()}, Vector3d::Zero(), 1e-3);
    told.note_delivered(Vector3d::Zero());
    untold.update(body.body(), {SingleAxis::wanted()}, Vector3d::Zero(), 1e-3);
  }
  EXPECT_NEAR(told.disturbance().norm(), 0, 1e-6);
  EXPECT_GT(untold.disturbance().norm(), 100);
}

// Position: a mass pushed by a steady force, by the same formula.
TEST(SlidingMode, HoldsAPosition) {
  constexpr double kMass = 1210;
  PositionSlidingMode control(kSlidingGains, 0, kMass);
  BodyState body;
  const Vector3d load(20, 0, -10);
  for (int i = 0; i < 40'000; ++i) {
    const Wrench demand = control.update(body, {}, Vector3d::Zero(), 1e-3);
    EXPECT_EQ(demand.torque.norm(), 0);
    body.velocity += 1e-3 / kMass * (demand.force + load);
    body.position += 1e-3 * body.velocity;
  }
  const Vector3d predicted =
      load / kMass / (kSlidingGains.reaching + kSlidingGains.switching / kSlidingGains.layer) / kSlidingGains.slope;
  EXPECT_NEAR((body.position - predicted).norm(), 0, 1e-9);
}

// The observer of the position counts the known contact: 30 N of which 20 N are known.
TEST(SlidingMode, ObserverEstimatesTheForceThatIsNotKnown) {
  constexpr double kMass = 1210;
  PositionSlidingMode control(kSlidingGains, 5, kMass);
  BodyState body;
  for (int i = 0; i < 10'000; ++i) {
    const Wrench demand = control.update(body, {}, Vector3d(0, 20, 0), 1e-3);
    body.velocity += 1e-3 / kMass * (demand.force + Vector3d(0, 30, 0));
    body.position += 1e-3 * body.velocity;
  }
  EXPECT_NEAR((control.disturbance() - Vector3d(0, 10, 0)).norm(), 0, 1e-6);
}

const DoubleLoopSettings kLoops = {.slope = 0.3,
                                   .outer_switching = 0.01,
                                   .outer_layer = 0.05,
                                   .fastest = 0.05,
                                   .inner = {.reaching = 5, .switching = 0.05, .layer = 0.002},
                                   .observer_bandwidth = 10};

// A large slew goes at the largest rate. Close to the end the error decays with the rate c + h_o/phi_o = 0.5.
TEST(DoubleLoop, SlewsAtItsLargestRateAndDecaysAsTheOuterLoop) {
  DoubleLoop control(kLoops, SingleAxis::inertia());
  SingleAxis body = {1, 0};
  double begin = 0, end = 0, fastest = 0;
  for (int i = 0; i < 40'000; ++i) {
    const double before = body.angle, t = i * 1e-3;
    body.turn(about_axis(control.update(body.body(), {SingleAxis::wanted()}, 1e-3).torque), 1e-3);
    fastest = std::max(fastest, -body.rate);
    if (before > 0.02 && body.angle <= 0.02) begin = t;
    if (before > 0.001 && body.angle <= 0.001) end = t;
  }
  EXPECT_NEAR(fastest, kLoops.fastest, 1e-4);
  EXPECT_NEAR((end - begin) * 0.5, std::log(20), 0.01);
  EXPECT_NEAR(body.angle, 0, 1e-4);
}

// On the inner loop's surface the rate is r, and the demand is J r'. Inside the outer layer r' = -(c + h_o/phi_o) e',
// beyond it -c e', and 0 where r is cut.
TEST(DoubleLoop, FeedsTheDerivativeOfTheWantedRateForward) {
  const auto torque = [](double angle, double rate) {
    DoubleLoop control(kLoops, SingleAxis::inertia());
    return about_axis(control.update(SingleAxis{angle, rate}.body(), {SingleAxis::wanted()}, 1e-3).torque);
  };
  EXPECT_NEAR(torque(0.02, -0.01), SingleAxis::moment() * 0.5 * 0.01, 1e-9);
  EXPECT_NEAR(torque(0.1, -0.04), SingleAxis::moment() * 0.3 * 0.04, 1e-9);
  EXPECT_NEAR(torque(1, -0.05), 0, 1e-9);
}

// With the observer a steady torque leaves no error.
TEST(DoubleLoop, ObserverTakesUpASteadyTorque) {
  DoubleLoop control(kLoops, SingleAxis::inertia());
  SingleAxis body;
  for (int i = 0; i < 40'000; ++i) {
    body.turn(about_axis(control.update(body.body(), {SingleAxis::wanted()}, 1e-3).torque) + 200, 1e-3);
  }
  EXPECT_NEAR(body.angle, 0, 1e-9);
  EXPECT_NEAR((control.disturbance() - Vector3d(0, 200, 0)).norm(), 0, 1e-6);
}

}  // namespace
}  // namespace netpocket
