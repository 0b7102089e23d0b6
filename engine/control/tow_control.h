#pragma once
// Tows by thrust along the tow line: PID (pid.h) on one quantity of the line, with an optional cap on its tension.
//
// The quantity is what pulling increases: the separation of spacecraft and target (m), the elongation of the rope (m),
// or the speed of towing (m/s; then without derivative gain).

#include <optional>

#include "engine/control/pid.h"
#include "engine/control/tension_cap.h"

namespace netpocket {

struct TowMeasurement {
  double value;    // of the quantity
  double rate;     // its derivative, 1/s
  double tension;  // N, of the tow line
};

struct TowReference {
  double value;             // wanted
  double rate = 0;          // its derivative, 1/s
  double feed_forward = 0;  // N, thrust known to be needed, such as total mass times wanted acceleration
};

class TowControl {
 public:
  explicit TowControl(const PidSettings& pid, const std::optional<TensionCapSettings>& cap = {});

  // Thrust (N) along the line after another period `dt` (s), positive away from the target.
  double update(const TowMeasurement& measured, const TowReference& wanted, double dt);

  void visit_state(const NumberVisitor& visit);

 private:
  Pid pid_;
  std::optional<TensionCap> cap_;
};

}  // namespace netpocket
