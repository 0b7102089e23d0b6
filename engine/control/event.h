#pragma once
// An event of a run: the first time at which a condition has held for a while.

#include "engine/control/visited_numbers.h"

namespace netpocket {

struct EventCondition {
  enum class Kind {
    time,           // the time reaches `level` (s)
    above,          // the watched value reaches `level` or exceeds it
    below,          // the watched value reaches `level` or falls below it
    target_inside,  // the target is inside the pocket
  };

  Kind kind = Kind::time;
  double level = 0;
  double hold = 0;  // s, how long the condition must hold without a break
};

// What an event sees at one time.
struct EventView {
  double time = 0;             // s
  double value = 0;            // of the watched channel
  bool target_inside = false;  // whether the target is inside the pocket
};

// Latched: an event that has happened stays so. A condition that holds at the first look counts from there.
class Event {
 public:
  explicit Event(const EventCondition& condition) : condition_(condition) {}

  // Looks at the run; times must not fall. Returns whether the event has happened.
  bool look(const EventView& view);

  bool has_happened() const { return happened_; }
  // Time (s) at which the condition had held for long enough, once the event has happened. Between two looks the time
  // of a crossing is interpolated linearly.
  double time() const { return time_; }

  void visit_state(const NumberVisitor& visit);

 private:
  bool holds(const EventView& view) const;
  double crossing(const EventView& view) const;

  EventCondition condition_;
  bool looked_ = false, holding_ = false, happened_ = false;
  double since_ = 0;  // s, when the condition began to hold
  double time_ = 0;
  double last_time_ = 0, last_value_ = 0;  // of the last look
};

}  // namespace netpocket
