#pragma once
// Reaction wheels of a body, with limits of torque and momentum.
//
// With the unit axes a_i and the momenta h_i along them the wheels exert on the body, in body axes,
//   torque = -sum a_i h_i' - w x sum a_i h_i,
// so that the angular momentum of body and wheels is constant (Wie, Space Vehicle Dynamics and Control (2008), chapter
// 7). h_i' are allocated to the wanted torque by least squares within the torque limits, least in size. A wheel at its
// momentum limit takes up no more, and the others have its part as far as they can.

#include <Eigen/Core>
#include <vector>

#include "engine/control/visited_numbers.h"
#include "engine/dynamics/assembly/dynamic_body.h"

namespace netpocket {

struct ReactionWheel {
  Eigen::Vector3d axis;      // body axes; any length but 0
  double most_torque = 0;    // N m, positive
  double most_momentum = 0;  // N m s, positive
};

class ReactionWheels {
 public:
  // The wheels begin at rest relative to the body. Throws std::invalid_argument unless they are as described above.
  explicit ReactionWheels(const std::vector<ReactionWheel>& wheels);

  // Commands the wanted torque (N m, body axes) until the next command. It is that of the first term: a controller that
  // wants to cancel the second one adds w x momentum().
  void command(const Eigen::Vector3d& wanted);
  // The mean torque on the body (body axes, no force) over the next `dt` (s), for its angular velocity (rad/s, body
  // axes).
  Wrench step(const Eigen::Vector3d& angular_velocity, double dt);

  double load() const;  // largest part of a torque limit in the last command; 1 if a wheel is at its momentum limit
  Eigen::Vector3d momentum() const;                                      // sum a_i h_i, N m s, body axes
  const std::vector<double>& wheel_momenta() const { return momenta_; }  // h_i, N m s

  void visit_state(const NumberVisitor& visit);

 private:
  std::vector<ReactionWheel> wheels_;
  Eigen::MatrixXd axes_;         // columns
  std::vector<double> momenta_;  // N m s
  std::vector<double> torques_;  // commanded h_i', N m
};

}  // namespace netpocket
