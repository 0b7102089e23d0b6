#pragma once
// Sliding mode law with boundary layer for a double integrator, with or without an extended state observer.
//
// With the tracking error e of three components, by component:
//   s = e' + c e                                        sliding variable
//   u = -c e' - k s - h sat(s/phi) - d                  demanded acceleration
// sat cuts to [-1, 1]; d is the disturbance's estimate (extended_state_observer.h), or 0. Without disturbance
// s' = -k s - h sat(s/phi): from s0 the layer |s| <= phi is reached after ln((k |s0| + h)/(k phi + h))/k, and then e
// decays with the rate c. In the layer a steady disturbance d0 that is not estimated leaves s = d0/(k + h/phi).
// Sources: reaching law of Gao & Hung 1993, doi:10.1109/41.184817; boundary layer of Slotine & Li, Applied Nonlinear
// Control (1991), chapter 7.

#include <Eigen/Core>
#include <optional>

#include "engine/control/extended_state_observer.h"
#include "engine/control/tracking_error.h"

namespace netpocket {

// With e in m or rad. A switching gain larger than the largest disturbance left to it keeps |s| <= phi.
struct SlidingModeGains {
  double slope = 0;      // c, 1/s
  double reaching = 0;   // k, 1/s
  double switching = 0;  // h, m/s^2 or rad/s^2
  double layer = 0;      // phi, m/s or rad/s; 0: sat is the sign
};

// sat(x/width), the sign of x (0 for 0) for width 0.
double saturation(double x, double width);
Eigen::Vector3d saturation(const Eigen::Vector3d& x, double width);

// -k s - h sat(s/phi)
Eigen::Vector3d reaching_law(const SlidingModeGains& gains, const Eigen::Vector3d& s);

class SlidingModeLaw {
 public:
  // `observer_bandwidth` in rad/s; 0: no observer.
  SlidingModeLaw(const SlidingModeGains& gains, double observer_bandwidth);

  // Demanded acceleration after another period `dt` (s). `velocity`: the present one; `known`: the acceleration known
  // to have acted during the period. All in the same axes.
  Eigen::Vector3d update(const TrackingError& error, const Eigen::Vector3d& velocity, const Eigen::Vector3d& known,
                         double dt);

  Eigen::Vector3d sliding_variable(const TrackingError& error) const { return error.rate + gains_.slope * error.error; }
  Eigen::Vector3d disturbance() const;  // estimate, m/s^2 or rad/s^2

  void visit_state(const NumberVisitor& visit);

 private:
  SlidingModeGains gains_;
  std::optional<ExtendedStateObserver> observer_;
};

}  // namespace netpocket
