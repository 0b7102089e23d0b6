#pragma once
// What a capture costs by its phases: how far an impact turns the spacecraft, the tension that closing takes, and the
// force of the towing. Thread contract: one thread at a time per object.

#include <limits>
#include <optional>
#include <vector>

#include "engine/state/phase.h"
#include "engine/state/snapshot.h"

namespace netpocket {

class PhasePeaks {
 public:
  // `spacecraft`: index into Structure::bodies, if there is one. `phases`: those that are known before the run; where
  // events begin them, the channel of the phase tells them (kPhaseChannel).
  PhasePeaks(std::optional<std::size_t> spacecraft, std::vector<Phase> phases);

  // Snapshots in the order of their times. `touched`: whether cords have touched the target by then.
  void add(const Snapshot& snapshot, bool touched);

  // NaN where there is nothing to tell, as without contact or towing. Angles in rad, forces in N.
  double attitude() const { return attitude_; }        // from the attitude at the start, over the whole run
  double impact() const { return impact_; }            // the same, from first contact until the towing
  double closing_tension() const { return tension_; }  // of the closing ropes, mean over the sides, while closing
  double end_tension() const;                          // its mean over the last fifth of the closing
  double towing_force() const { return force_; }       // pull of the pocket on the target along -Y while towing
  double towing_thrust() const { return thrust_; }     // of the actuators along -Y while towing

 private:
  std::string phase_of(const Snapshot& snapshot) const;
  void add_attitude(const Snapshot& snapshot, bool touched, bool tows);

  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  std::optional<std::size_t> spacecraft_;
  std::vector<Phase> phases_;
  std::optional<Eigen::Quaterniond> start_;
  bool has_towed_ = false;
  std::vector<double> times_, tensions_;  // s, N, of the frames of the closing
  double attitude_ = kNone, impact_ = kNone, tension_ = kNone, force_ = kNone, thrust_ = kNone;
};

}  // namespace netpocket
