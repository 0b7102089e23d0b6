// What towing asks of the spacecraft.
#include "engine/control/towing.h"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/engine/dynamics/models.h"

namespace netpocket {
namespace {

Eigen::Vector3d point_of_thrust(double offset, double angle) {
  TowingParameters towing;
  towing.start = 0;
  towing.offset = offset;
  towing.offset_angle = angle;
  return SpacecraftDrive(towing, StationKeeping::free, 1).at(1, {}).point;
}

// Geometry; tolerance: round-off.
TEST(Towing, LineOfThrustIsOffInItsDirection) {
  EXPECT_EQ(point_of_thrust(0.005, 0), Eigen::Vector3d(0.005, 0, 0));  // to the last bit: the plane of symmetry stays
  EXPECT_TRUE(point_of_thrust(2, std::numbers::pi / 2).isApprox(Eigen::Vector3d(0, 0, 2), 1e-15));
  EXPECT_TRUE(point_of_thrust(2, std::numbers::pi / 6).isApprox(Eigen::Vector3d(std::sqrt(3.0), 0, 1), 1e-15));
}

TEST(Towing, PullsOnlyFromItsStart) {
  TowingParameters towing;
  towing.start = 10;
  SpacecraftDrive drive(towing, StationKeeping::free, 1000);
  EXPECT_EQ(drive.at(9.9, {}).force, Eigen::Vector3d(0, 0, 0));
  EXPECT_EQ(drive.at(9.9, {}).point, Eigen::Vector3d(0, 0, 0));
  // Half way the thrust is the whole: size times mass, towards -Y.
  EXPECT_EQ(drive.at(10 + towing.duration / 2, {}).force, Eigen::Vector3d(0, -1000 * towing.size, 0));
}

// A spacecraft that something pulls at steadily, with a light cord clamped to it off its centre.
class TowedBody {
 public:
  static constexpr double kMass = 1200, kStep = 1e-3;

  TowedBody() : cable_(test::straight_cable(test::plain_cable(1e-3, 1e-9, 0.1), {1, 0, 0}, {2, 0.5, 0}, 1)) {
    Model& model = cable_.model;
    model.add_body({.name = "spacecraft",
                    .shape = Box{{1, 1, 1}},
                    .mass = kMass,
                    .inertia = Eigen::Vector3d(400, 500, 600).asDiagonal(),
                    .state = {}});
    model.clamp_to_body(cable_.nodes.front(), cable_.gradients.front(), 0);
    model.gravity = {0.004, 0.02, -0.003};
    system_.emplace(cable_.model);
  }

  CableSystem& system() { return *system_; }
  void step(SpacecraftDrive& drive) {
    system_->control(0, drive.at(system_->time(), system_->motion(0)));
    system_->step(kStep);
    drive.note_step(system_->exerted(0), system_->motion(0), kStep);
  }

 private:
  test::Cable cable_;
  std::optional<CableSystem> system_;
};

struct Command {
  TowingParameters towing;
  StationKeeping keeping;
};

std::vector<Command> all_commands(double size_factor) {
  std::vector<Command> commands;
  for (const TowingMode mode : {TowingMode::none, TowingMode::force, TowingMode::acceleration, TowingMode::velocity}) {
    for (const StationKeeping keeping : {StationKeeping::free, StationKeeping::attitude, StationKeeping::lateral}) {
      TowingParameters towing;
      towing.mode = mode;
      towing.start = 0.5;
      towing.duration = 3;
      towing.size = size_factor * (mode == TowingMode::force ? 24 : mode == TowingMode::acceleration ? 0.02 : 0.1);
      towing.offset = 0.3 * size_factor;
      towing.offset_angle = 0.7;
      commands.push_back({towing, keeping});
    }
  }
  return commands;
}

// From each command to each other one in the midst of a pull. Forces are some 24 N, moments some 7 N m (24 N at 0.3
// m), and neither may change by more than 2 % (4 %) of that in a step of 1 ms: over half a second smoothly the most is
// 15/8 of 1/500, 0.4 %, for what ends and what begins each, and a thrust that rises over its flank of 0.3 s adds 0.7 %.
// A rotation that is stopped within half a second, 0.014 rad/s of 500 kg m^2, takes up to 5.8 of that per 0.25 s^2, 2.2
// % of 7 N m in a step. The force that a velocity takes is known from a mean over 0.02 s, in which it changes by up to
// 0.02 s times 90 N/s. A blow would be 24 N at once, or a jump of the velocity.
TEST(Towing, NoChangeIsABlow) {
  constexpr double kForce = 0.02 * 24, kTorque = 0.04 * 24 * 0.3;
  for (const Command& before : all_commands(1)) {
    for (const Command& after : all_commands(0.6)) {
      TowedBody body;
      SpacecraftDrive drive(before.towing, before.keeping, TowedBody::kMass);
      while (body.system().time() < 1.5) body.step(drive);
      Wrench last = body.system().exerted(0);
      Eigen::Vector3d velocity = body.system().motion(0).velocity;
      drive.change(after.towing, after.keeping, body.system().time());
      double force = 0, torque = 0, acceleration = 0;
      while (body.system().time() < 5) {
        body.step(drive);
        force = std::max(force, (body.system().exerted(0).force - last.force).norm());
        torque = std::max(torque, (body.system().exerted(0).torque - last.torque).norm());
        acceleration = std::max(acceleration, (body.system().motion(0).velocity - velocity).norm() / TowedBody::kStep);
        last = body.system().exerted(0);
        velocity = body.system().motion(0).velocity;
      }
      const auto name = [](const Command& command) {
        return std::to_string(static_cast<int>(command.towing.mode)) +
               std::to_string(static_cast<int>(command.keeping));
      };
      SCOPED_TRACE("from " + name(before) + " to " + name(after));
      EXPECT_LT(force, kForce + (before.towing.mode == TowingMode::velocity ? 0.02 * 90 : 0));
      EXPECT_LT(torque, kTorque);
      EXPECT_LT(acceleration,
                0.15);  // m/s^2: 0.1 m/s over 3 s by a cycloid and 0.05 m/s over half a second, and the pull
      // What is asked for is reached.
      const RigidMotion motion = body.system().motion(0);
      if (after.towing.mode == TowingMode::velocity) {
        EXPECT_NEAR(motion.velocity.y(), -0.06, 1e-9);
      }
      if (after.keeping == StationKeeping::lateral) {
        EXPECT_LT(std::abs(motion.velocity.x()), 1e-9);
      }
      if (after.keeping != StationKeeping::free) {
        EXPECT_LT(motion.angular_velocity.norm(), 1e-9);
      }
      ASSERT_FALSE(testing::Test::HasFailure());
    }
  }
}

// A tow at a given velocity begins where the spacecraft is, whatever it did before: at once, when its start has passed.
TEST(Towing, VelocityStartsFromThePresentOne) {
  TowingParameters towing;
  towing.mode = TowingMode::none;
  SpacecraftDrive drive(towing, StationKeeping::free, 1000);
  const RigidMotion motion{.velocity = {0, -0.3, 0}};
  drive.at(12, motion);
  towing.mode = TowingMode::velocity;
  towing.start = 10;
  towing.duration = 4;
  towing.size = 0.1;
  drive.change(towing, StationKeeping::free, 12);
  EXPECT_EQ(drive.at(12, motion).velocity[1], -0.3);
  EXPECT_NEAR(*drive.at(14, motion).velocity[1], -0.2, 1e-12);
  EXPECT_NEAR(*drive.at(16, motion).velocity[1], -0.1, 1e-12);
}

// Neither a change that changes nothing nor one of the station keeping starts a tow anew.
TEST(Towing, OtherChangesLeaveATowAlone) {
  TowingParameters towing;
  towing.mode = TowingMode::velocity;
  towing.start = 10;
  towing.duration = 4;
  towing.size = 0.1;
  SpacecraftDrive drive(towing, StationKeeping::free, 1000), other = drive;
  for (const double time : {9.0, 10.0, 11.0, 12.0, 13.0}) {
    if (time == 12) other.change(towing, StationKeeping::free, time);
    if (time == 13) other.change(towing, StationKeeping::lateral, time);
    EXPECT_EQ(drive.at(time, {}).velocity[1], other.at(time, {}).velocity[1]) << time;
  }
}

}  // namespace
}  // namespace netpocket
