// Every class of closed-loop control with a state goes on with the same bits from its saved numbers.

#include "tests/engine/control/resume.h"

#include <array>
#include <cmath>

#include "engine/control/double_loop.h"
#include "engine/control/event.h"
#include "engine/control/position_pid.h"
#include "engine/control/reaction_wheels.h"
#include "engine/control/sensor_channel.h"
#include "engine/control/sliding_mode_control.h"
#include "engine/control/thrusters.h"
#include "engine/control/tow_control.h"
#include "engine/control/winch.h"
#include "engine/control/wrench_box.h"
#include "engine/math/rotation.h"

namespace netpocket {
namespace {

using Eigen::Vector3d;
using test::expect_resumes;

constexpr double kTick = 0.01;  // s

// A motion that excites all components.
BodyState motion_at(int i) {
  const double t = 0.1 * i;
  return {.position = {std::sin(t), std::cos(2 * t), 0.3 * t},
          .attitude = rotation_by(Vector3d(0.1 * std::sin(3 * t), 0.2 * std::cos(t), 0.05 * t)),
          .velocity = {std::cos(t), std::sin(t), 0.3},
          .angular_velocity = {0.1 * std::cos(t), 0.2, std::sin(2 * t)}};
}

Wrench wrench_at(int i) { return {motion_at(i).position, motion_at(i).angular_velocity}; }

double sum(const Wrench& wrench) { return wrench.force.sum() + wrench.torque.sum(); }

const SlidingModeGains kSomeGains = {.slope = 1, .reaching = 2, .switching = 0.1, .layer = 0.01};
const Eigen::Matrix3d kSomeInertia = Vector3d(2, 3, 4).asDiagonal();

TEST(Resume, RandomNumbers) {
  expect_resumes(RandomNumbers(7), [](RandomNumbers& random, int) { return random.normal(); });
}

TEST(Resume, PositionPid) {
  const PidSettings axis = {.proportional = 3, .integral = 2, .derivative = 1, .least = -2, .most = 2};
  expect_resumes(PositionPid({axis, axis, axis}, 10),
                 [](PositionPid& pid, int i) { return sum(pid.update(motion_at(i), {}, kTick)); });
}

TEST(Resume, SlidingModeWithObserver) {
  expect_resumes(AttitudeSlidingMode(kSomeGains, 20, kSomeInertia), [](AttitudeSlidingMode& control, int i) {
    return sum(control.update(motion_at(i), {}, Vector3d(1, 0, 0), kTick));
  });
  expect_resumes(PositionSlidingMode(kSomeGains, 20, 5), [](PositionSlidingMode& control, int i) {
    return sum(control.update(motion_at(i), {}, Vector3d(1, 0, 0), kTick));
  });
}

TEST(Resume, DoubleLoop) {
  const DoubleLoopSettings settings = {.slope = 1, .inner = kSomeGains, .observer_bandwidth = 20};
  expect_resumes(DoubleLoop(settings, kSomeInertia),
                 [](DoubleLoop& control, int i) { return sum(control.update(motion_at(i), {}, kTick)); });
}

TEST(Resume, TowControl) {
  const TowControl tow({.proportional = 3, .integral = 2}, TensionCapSettings{.cap = 1});
  expect_resumes(tow, [](TowControl& control, int i) {
    return control.update({std::sin(0.1 * i), 0, 1 + std::cos(0.3 * i)}, {2}, kTick);
  });
}

TEST(Resume, SensorChannel) {
  const SensorSettings settings = {.rate = 50, .delay = 0.07, .dropout = 0.3, .noise = {0.1, 0.2}, .bias = {1, 2}};
  expect_resumes(SensorChannel(settings, 2), [](SensorChannel& sensor, int i) {
    sensor.look(kTick * i, std::array{std::sin(0.1 * i), 0.0});
    return sensor.reading()[0] + sensor.reading()[1] + sensor.age();
  });
}

TEST(Resume, Thrusters) {
  const Thrusters thrusters({{.position = {1, 0, 0}, .direction = {0, 1, 0}, .thrust = 1, .impulse_bit = 0.004},
                             {.position = {0, 0, 1}, .direction = {-1, 0, 1}, .thrust = 2}},
                            0.02);
  expect_resumes(thrusters, [](Thrusters& actuator, int i) {
    if (i % 4 == 0) actuator.command(wrench_at(i), 4 * kTick);
    return sum(actuator.step(kTick)) + actuator.propellant();
  });
}

TEST(Resume, WrenchBox) {
  const WrenchBox box({.most_force = {0.5, 0.5, 0.5}, .most_torque = {0.1, 0.1, 0.1}, .time_constant = 0.05});
  expect_resumes(box, [](WrenchBox& actuator, int i) {
    if (i % 4 == 0) actuator.command(wrench_at(i));
    return sum(actuator.step(kTick)) + actuator.propellant();
  });
}

TEST(Resume, ReactionWheels) {
  const ReactionWheels wheels({{{1, 0, 0}, 1, 0.05}, {{0, 1, 0}, 1, 0.05}, {{0, 1, 1}, 1, 0.05}});
  expect_resumes(wheels, [](ReactionWheels& actuator, int i) {
    if (i % 4 == 0) actuator.command(wrench_at(i).torque);
    return sum(actuator.step(motion_at(i).angular_velocity, kTick));
  });
}

TEST(Resume, WinchInEveryMode) {
  for (const WinchMode mode : {WinchMode::torque, WinchMode::rate, WinchMode::length, WinchMode::tension}) {
    expect_resumes(Winch({.rate_integral = 5, .tension_derivative = 1e-3}, 5), [&](Winch& winch, int i) {
      if (i == 0) winch.command({.mode = mode, .value = 0.2});
      if (i == 30) winch.command({.brake = true});
      winch.step(20 + 10 * std::sin(0.5 * i), kTick);
      return winch.motion().length + winch.motor_work() + winch.losses();
    });
  }
}

TEST(Resume, Event) {
  const Event event({.kind = EventCondition::Kind::above, .level = 20.5, .hold = 5});
  expect_resumes(event, [](Event& watched, int i) { return watched.look({1.0 * i, 1.0 * i}) ? watched.time() : 0; });
}

}  // namespace
}  // namespace netpocket
