#include "engine/bodies/rigid_body.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>

#include "engine/bodies/shape.h"

namespace netpocket {
namespace {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

const Matrix3d kBoxInertia = solid_inertia(Box{{1, 2, 3}}, 12);  // 13, 10, 5

Quaterniond rotation_by(const Vector3d& vector) {
  return Quaterniond(Eigen::AngleAxisd(vector.norm(), vector.normalized()));
}

// An inertia with products: kBoxInertia seen from turned body axes.
Matrix3d turned_inertia() {
  const Matrix3d turn = rotation_by({0.3, -0.7, 0.5}).toRotationMatrix();
  const Matrix3d inertia = turn * kBoxInertia * turn.transpose();
  return 0.5 * (inertia + inertia.transpose());
}

TEST(RigidBody, RestStaysExactlyAtRest) {
  for (const Matrix3d& inertia : {kBoxInertia, turned_inertia()}) {
    RigidBody body(200, inertia);
    for (int i = 0; i < 1000; ++i) {
      body.kick(Vector3d::Zero(), Vector3d::Zero(), 1e-4);
      body.drift(1e-4);
    }
    EXPECT_EQ(body.rotation(), Matrix3d::Identity());
    EXPECT_EQ(body.attitude().coeffs(), Quaterniond::Identity().coeffs());
    EXPECT_EQ(body.position(), Vector3d::Zero());
    EXPECT_EQ(body.angular_velocity(), Vector3d::Zero());
  }
}

TEST(RigidBody, TorqueAboutYTurnsAboutYOnly) {
  RigidBody body(1210, Vector3d(4282, 12736, 14498).asDiagonal());
  for (int i = 0; i < 1000; ++i) {
    body.kick({0, 5, 0}, {0, 300, 0}, 1e-2);
    body.drift(1e-2);
  }
  EXPECT_EQ(body.attitude().x(), 0);
  EXPECT_EQ(body.attitude().z(), 0);
  EXPECT_EQ(body.position().x(), 0);
  EXPECT_NEAR(body.angular_velocity().y(), 300.0 / 12736 * 10, 1e-13);
}

TEST(RigidBody, SphereTurnsUniformlyWhateverTheStep) {
  const Vector3d spin(0.4, -1.1, 0.7);
  RigidBody body(200, 1210 * Matrix3d::Identity());
  body.set_angular_velocity(spin);
  for (int i = 0; i < 100; ++i) body.drift(0.5);
  EXPECT_LT(body.attitude().angularDistance(rotation_by(50 * spin)), 1e-13);
  EXPECT_EQ(body.angular_velocity(), Vector3d(1210 * spin) * (1 / 1210.0));
}

// Euler's top with two equal moments: the symmetry axis goes round the fixed angular momentum at the rate |L|/I_1.
TEST(RigidBody, SymmetricTopPrecessesAsInTheory) {
  for (const Vector3d& moments : {Vector3d(21, 24, 21), Vector3d(30, 8, 30)}) {
    RigidBody body(12, moments.asDiagonal());
    body.set_angular_velocity({0.5, 2, -0.3});
    const Vector3d momentum = body.angular_momentum();
    const double dt = 0.05;
    double largest_error = 0;
    for (int i = 1; i <= 2000; ++i) {
      body.drift(dt);
      const Vector3d expected = rotation_by(i * dt / moments.x() * momentum) * Vector3d::UnitY();
      largest_error = std::max(largest_error, (body.rotation().col(1) - expected).norm());
    }
    RecordProperty("largest_error", std::to_string(largest_error));
    // The splitting is exact here: what remains is the round-off of 2000 rotations.
    EXPECT_LT(largest_error, 1e-12);
    EXPECT_EQ(body.angular_momentum(), momentum);
  }
}

struct EnergyRecord {
  double swing = 0;  // largest relative deviation from the start
  double drift = 0;  // relative change of the mean from the first tenth to the last tenth
};

EnergyRecord tumble(const Matrix3d& inertia, int steps_per_revolution) {
  RigidBody body(12, inertia);
  // About the intermediate axis (10 kg m^2) with a small disturbance: the body flips over again and again.
  const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(inertia);
  body.set_angular_velocity(solver.eigenvectors() * Vector3d(0.01, 1, 0));
  const Vector3d momentum = body.angular_momentum();
  const double energy = body.kinetic_energy();
  const int steps = 100 * steps_per_revolution;
  EnergyRecord record;
  double first = 0, last = 0;
  bool flipped = false;
  for (int i = 0; i < steps; ++i) {
    body.drift(2 * std::numbers::pi / steps_per_revolution);
    const double change = body.kinetic_energy() / energy - 1;
    record.swing = std::max(record.swing, std::abs(change));
    if (i < steps / 10) first += change;
    if (i >= steps - steps / 10) last += change;
    flipped = flipped || (body.rotation() * solver.eigenvectors().col(1)).dot(momentum.normalized()) < -0.9;
  }
  EXPECT_TRUE(flipped);
  EXPECT_EQ(body.angular_momentum(), momentum);
  // The momentum that the turned body has is the stored one.
  const Vector3d carried = body.rotation() * inertia * body.rotation().transpose() * body.angular_velocity();
  EXPECT_LT((carried - momentum).norm() / momentum.norm(), 1e-14);
  record.drift = std::abs(last - first) / (steps / 10);
  return record;
}

// A run that has failed takes another step or two before that is seen.
TEST(RigidBody, SurvivesWhatIsNoNumber) {
  for (const double spin : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    RigidBody body(12, kBoxInertia);
    body.kick(Vector3d::Zero(), Vector3d(0, spin, 0), 1);
    body.drift(1e-3);
    EXPECT_FALSE(std::isfinite(body.kinetic_energy()));
  }
}

TEST(RigidBody, TumblingKeepsItsEnergy) {
  for (const Matrix3d& inertia : {kBoxInertia, turned_inertia()}) {
    // Steps so small that they are one turn each.
    const EnergyRecord coarse = tumble(inertia, 8000);
    const EnergyRecord fine = tumble(inertia, 16000);
    RecordProperty("swing_at_16000_steps_per_revolution", std::to_string(fine.swing));
    std::printf("energy: swing %.2e, drift %.2e at 8000; swing %.2e, drift %.2e at 16000 steps per revolution\n",
                coarse.swing, coarse.drift, fine.swing, fine.drift);
    EXPECT_LT(fine.drift, 1e-6);
    EXPECT_LT(fine.swing, 1e-8);                       // bounded: (2 pi/16000)^2 times the share of the spin in it
    EXPECT_NEAR(coarse.swing / fine.swing, 4.0, 0.2);  // and of second order
    EXPECT_LT(tumble(inertia, 500).swing, 1e-7);       // large steps turn in parts
  }
}

// Heavy asymmetric top as a first-order system, for a Runge-Kutta reference.
struct HeavyTop {
  Matrix3d inertia = turned_inertia();
  Vector3d arm{0.2, 0.5, -0.1};  // m, body axes, from the pivot at the origin to the weight
  Vector3d weight{3, -20, 1};    // N, world

  Vector3d torque(const Matrix3d& rotation) const { return (rotation * arm).cross(weight); }

  using State = Eigen::Matrix<double, 3, 4>;  // rotation matrix | angular momentum
  State derivative(const State& s) const {
    const Matrix3d rotation = s.leftCols<3>();
    const Vector3d spin = rotation * inertia.inverse() * rotation.transpose() * s.col(3);
    State d;
    for (int k = 0; k < 3; ++k) d.col(k) = spin.cross(s.col(k));
    d.col(3) = torque(rotation);
    return d;
  }
  State runge_kutta(State s, double end, int steps) const {
    const double h = end / steps;
    for (int i = 0; i < steps; ++i) {
      const State k1 = derivative(s), k2 = derivative(s + h / 2 * k1), k3 = derivative(s + h / 2 * k2),
                  k4 = derivative(s + h * k3);
      s += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    }
    return s;
  }
};

TEST(RigidBody, LeapfrogIsOfSecondOrder) {
  const HeavyTop top;
  RigidBody start(12, top.inertia);
  start.set_angular_velocity({1, -0.5, 2});
  HeavyTop::State initial;
  initial << start.rotation(), start.angular_momentum();
  const double end = 3;
  const Matrix3d exact = top.runge_kutta(initial, end, 20000).leftCols<3>();

  const auto error = [&](int steps) {
    RigidBody body = start;
    const double dt = end / steps;
    for (int i = 0; i < steps; ++i) {
      body.kick(Vector3d::Zero(), top.torque(body.rotation()), i == 0 ? dt / 2 : dt);
      body.drift(dt);
    }
    return (body.rotation() - exact).norm();
  };
  const double order = std::log2(error(400) / error(800));
  RecordProperty("order", std::to_string(order));
  std::printf("order of convergence %.3f, error %.2e at dt = %.2e s\n", order, error(800), end / 800);
  EXPECT_NEAR(order, 2.0, 0.05);
}

TEST(RigidBody, FallsAsInTheory) {
  RigidBody body(3, kBoxInertia);
  const double dt = 1e-3;
  for (int i = 0; i < 1000; ++i) {
    body.kick({0, -3 * 9.81, 0}, Vector3d::Zero(), i == 0 ? dt / 2 : dt);
    body.drift(dt);
  }
  EXPECT_NEAR(body.position().y(), -9.81 / 2, 1e-12);
}

TEST(RigidBody, AngularVelocityAndMomentumBelongTogether) {
  RigidBody body(12, turned_inertia());
  RigidBodyState state;
  state.attitude = rotation_by({1, 2, -0.5});
  state.angular_momentum = {3, -4, 5};
  body.set_state(state);
  const Matrix3d inertia = body.rotation() * body.inertia() * body.rotation().transpose();
  EXPECT_LT((inertia * body.angular_velocity() - state.angular_momentum).norm(), 1e-13);
  body.set_angular_velocity(body.angular_velocity());
  EXPECT_LT((body.angular_momentum() - state.angular_momentum).norm(), 1e-13);
  EXPECT_NEAR(body.kinetic_energy(), 0.5 * state.angular_momentum.dot(inertia.inverse() * state.angular_momentum),
              1e-13);
}

TEST(RigidBody, PointsMoveWithTheBody) {
  RigidBodyState state;
  state.position = {1, 2, 3};
  state.velocity = {-0.4, 0.1, 0.2};
  state.attitude = rotation_by({0.3, 0.2, -1});
  RigidBody body(12, turned_inertia(), state);
  body.set_angular_velocity({0.5, -0.2, 0.9});
  const Vector3d marker(0.7, -1.1, 0.4);
  const Vector3d before = body.to_world(marker);
  EXPECT_LT((body.to_body(before) - marker).norm(), 1e-15);
  const Vector3d velocity = body.velocity_at(before);
  const double dt = 1e-6;
  body.drift(dt);
  // The arc leaves its tangent by w^2 r dt / 2 = 1e-6 m/s.
  EXPECT_LT(((body.to_world(marker) - before) / dt - velocity).norm(), 2e-6);
}

TEST(RigidBody, InverseMassIsTheAnswerToAnImpulse) {
  RigidBodyState state;
  state.attitude = rotation_by({0.3, 0.2, -1});
  RigidBody body(12, turned_inertia(), state);
  const Vector3d point(0.4, 1.3, -0.8);
  const Vector3d direction = Vector3d(1, -2, 2) / 3;
  const double expected = body.inverse_mass_at(point, direction);
  body.kick(direction, point.cross(direction), 1);
  EXPECT_NEAR(body.velocity_at(point).dot(direction), expected, 1e-15);
  EXPECT_NEAR(RigidBody(4, kBoxInertia).inverse_mass_at({0, 2, 0}, Vector3d::UnitY()), 0.25, 1e-16);
}

TEST(RigidBody, RefusesImpossibleMassAndInertia) {
  EXPECT_THROW(RigidBody(0, kBoxInertia), std::invalid_argument);
  EXPECT_THROW(RigidBody(std::numeric_limits<double>::quiet_NaN(), kBoxInertia), std::invalid_argument);
  EXPECT_THROW(RigidBody(1, Vector3d(1, 0, 1).asDiagonal()), std::invalid_argument);
  EXPECT_THROW(RigidBody(1, Vector3d(1, -1, 1).asDiagonal()), std::invalid_argument);
  Matrix3d skewed = kBoxInertia;
  skewed(0, 1) = 1;
  EXPECT_THROW(RigidBody(1, skewed), std::invalid_argument);
}

}  // namespace
}  // namespace netpocket
