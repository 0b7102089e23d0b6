#pragma once
// Linear extended state observer: estimates the acceleration that an unknown disturbance adds to a known one.
//
// Plant by component: v' = a + d, with the measured velocity v, the known acceleration a and the disturbance d. The
// observer has the states z1 for v and z2 for d:
//   z1' = z2 + a + 2 w (v - z1),  z2' = w^2 (v - z1),
// with both poles at -w, the bandwidth (Gao 2003, doi:10.1109/ACC.2003.1242516). It is stepped in its current discrete
// form, both poles at b = exp(-w dt), which is stable for every period dt (Miklosovic, Radke & Gao 2006,
// doi:10.1109/ACC.2006.1656547):
//   predict  p = z1 + dt (a + z2);  correct  z1 = p + (1 - b^2) (v - p),  z2 += (1 - b)^2/dt (v - p).
// The error of z2 follows d' by (s + 2 w)/(s + w)^2, whose impulse response (1 + w t) exp(-w t) has the integral 2/w.
// So |d'| <= r bounds it by 2 r/w, after the initial error has decayed. A steady d' = r reaches the bound. In the
// discrete form this steady error is r dt ((1 + b)/(1 - b) - 1/2), which is below the bound for w dt < 3.5.

#include <Eigen/Core>

#include "engine/control/exponential_decay.h"
#include "engine/control/visited_numbers.h"

namespace netpocket {

class ExtendedStateObserver {
 public:
  explicit ExtendedStateObserver(double bandwidth) : decay_(bandwidth) {}  // rad/s

  // After another period `dt` (s): the present velocity and the known acceleration during the period, both in the same
  // axes; m/s and m/s^2, or rad/s and rad/s^2. The first call starts with the velocity and no disturbance.
  void update(const Eigen::Vector3d& velocity, const Eigen::Vector3d& known, double dt);

  const Eigen::Vector3d& velocity() const { return velocity_; }        // estimate
  const Eigen::Vector3d& disturbance() const { return disturbance_; }  // estimate, m/s^2 or rad/s^2

  void visit_state(const NumberVisitor& visit);

 private:
  ExponentialDecay decay_;
  bool started_ = false;
  Eigen::Vector3d velocity_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d disturbance_ = Eigen::Vector3d::Zero();
};

}  // namespace netpocket
