#pragma once
// When the phases of a capture begin and end, as far as that is known during a run.

#include <limits>

#include "engine/control/visited_numbers.h"
#include "engine/scenario/control_parameters.h"

namespace netpocket {

// Times in s; infinite: not yet, or never.
struct CaptureTimes {
  double closing_start = std::numeric_limits<double>::infinity();
  double closing_end = std::numeric_limits<double>::infinity();
  double towing_start = std::numeric_limits<double>::infinity();
  double towing_end = std::numeric_limits<double>::infinity();

  bool is_in(ControlPhase phase, double time) const {
    switch (phase) {
      case ControlPhase::open:
        return time < closing_start;
      case ControlPhase::closing:
        return time >= closing_start && time < closing_end;
      case ControlPhase::closed:
        return time >= closing_end && time < towing_start;
      case ControlPhase::towing:
        return time >= towing_start && time < towing_end;
      case ControlPhase::off:
        return false;
      case ControlPhase::always:
        break;
    }
    return true;
  }

  bool has_begun(ControlPhase phase, double time) const {
    switch (phase) {
      case ControlPhase::closing:
        return time >= closing_start;
      case ControlPhase::closed:
        return time >= closing_end;
      case ControlPhase::towing:
        return time >= towing_start;
      case ControlPhase::off:
        return false;
      case ControlPhase::open:
      case ControlPhase::always:
        break;
    }
    return true;
  }

  // Index into kPocketPhases (state/phase.h).
  int phase_at(double time) const {
    if (time >= towing_end) return 4;
    if (time >= towing_start) return 3;
    if (time >= closing_end) return 2;
    return time >= closing_start ? 1 : 0;
  }

  void visit_state(const NumberVisitor& visit) {
    for (double* time : {&closing_start, &closing_end, &towing_start, &towing_end}) visit(*time);
  }
};

}  // namespace netpocket
