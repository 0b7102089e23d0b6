#pragma once
// A rigid body that turns about one of its principal axes, which is oblique in the world. Its motion has closed forms.

#include <array>
#include <functional>

#include "engine/math/rotation.h"
#include "engine/state/snapshot.h"

namespace netpocket::test {

struct SingleAxis {
  double angle = 0, rate = 0;  // rad, rad/s, about the body's y axis

  static Eigen::Quaterniond reference() { return rotation_by(Eigen::Vector3d(0.4, -0.7, 1.1)); }
  static Eigen::Vector3d world_axis() { return reference() * Eigen::Vector3d::UnitY(); }
  static const Eigen::Matrix3d& inertia() {
    static const Eigen::Matrix3d matrix = Eigen::Vector3d(4282, 12736, 14498).asDiagonal();  // kg m^2, Tang et al. 2023
    return matrix;
  }
  static double moment() { return inertia()(1, 1); }

  BodyState body() const {
    BodyState state;
    state.attitude = reference() * rotation_by(angle * Eigen::Vector3d::UnitY());
    state.angular_velocity = rate * world_axis();
    return state;
  }
  static BodyState wanted() { return SingleAxis().body(); }

  // Steps with a torque (N m, about the axis) that is constant: exact.
  void turn(double torque, double dt) {
    const double acceleration = torque / moment();
    angle += dt * (rate + 0.5 * dt * acceleration);
    rate += dt * acceleration;
  }

  // Steps with a torque that follows the motion: classical Runge-Kutta.
  void turn(const std::function<double(const SingleAxis&)>& torque, double dt) {
    std::array<SingleAxis, 4> slopes;
    for (std::size_t i = 0; i < 4; ++i) {
      const double part = i == 0 ? 0 : (i == 3 ? dt : 0.5 * dt);
      const SingleAxis& last = slopes[i == 0 ? 0 : i - 1];
      const SingleAxis stage = i == 0 ? *this : SingleAxis{angle + part * last.angle, rate + part * last.rate};
      slopes[i] = {stage.rate, torque(stage) / moment()};
    }
    angle += dt / 6 * (slopes[0].angle + 2 * slopes[1].angle + 2 * slopes[2].angle + slopes[3].angle);
    rate += dt / 6 * (slopes[0].rate + 2 * slopes[1].rate + 2 * slopes[2].rate + slopes[3].rate);
  }
};

// Component of a world vector about the axis.
inline double about_axis(const Eigen::Vector3d& world) { return world.dot(SingleAxis::world_axis()); }

}  // namespace netpocket::test
