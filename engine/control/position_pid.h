#pragma once
// Position control by a force: PID (pid.h) along each world axis, plus the mass times the wanted acceleration. Without
// integral gain it is PD control.

#include <array>

#include "engine/control/pid.h"
#include "engine/control/tracking_error.h"
#include "engine/dynamics/assembly/dynamic_body.h"

namespace netpocket {

class PositionPid {
 public:
  // `axes`: by world axis; gains in N/m, N/(m s), N s/m, limits in N. `mass` in kg.
  PositionPid(const std::array<PidSettings, 3>& axes, double mass);

  // Force at the centre of mass, world axes, after another period `dt` (s); no torque.
  Wrench update(const BodyState& present, const WantedMotion& wanted, double dt);

  void visit_state(const NumberVisitor& visit);

 private:
  std::array<Pid, 3> axes_;
  double mass_;
};

}  // namespace netpocket
