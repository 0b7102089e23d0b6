#pragma once
// The largest stable step of a pocket as its closing ropes shorten and its cords bend, and what sets it.
//
// Short closing ropes hold the rods' tips more stiffly, so the bound of the whole (stable_step.h) is found anew each
// time they are 15 % shorter; the bound of one of their elements by itself follows their length at once; what bends and
// tensions add is asked for at each choice, and at each step while it varies much. Contacts are no stiffer than the
// step resolves, and limit it only when they are pressed deep (step_caution.h).
//
// Thread contract: one thread at a time.

#include <functional>
#include <limits>
#include <string>

#include "engine/dynamics/cable_system.h"
#include "engine/dynamics/stable_step.h"
#include "engine/dynamics/step_caution.h"
#include "engine/model/model.h"

namespace netpocket {

class StepChoice {
 public:
  // Of a system as built, which must outlive this; its closing ropes are all alike.
  explicit StepChoice(CableSystem& system);

  // Largest step (s, without a safety factor) from the system's present time until `end` (s) that is stable, with the
  // ropes wound by this law, and as cautious as need be.
  double stable_step(const std::function<RopeMotion(double)>& winding, double end);
  // After a step: whether the system's present shape no longer allows such a step (s). Looks only while bends and
  // strains vary.
  bool is_outgrown(double step);
  StepCaution& caution() { return caution_; }
  const StepCaution& caution() const { return caution_; }

  // As of the system at rest, before any choice. s
  double first_stable_step() const { return bound_.step; }

  // Notes that the last choice has led to a step of this size (s).
  void note(double step);
  // Smallest step noted, s; infinite before the first.
  double smallest_step() const { return smallest_step_; }
  // What has limited it, e.g. "axial waves in panel 3 row 2, and bends of cords".
  std::string limit() const;

  // Gives every number of the state to `visit`, which may change it.
  void visit_state(const std::function<void(double&)>& visit);

 private:
  enum class Cause : std::uint8_t { cables, bends, ropes };
  enum class Shortening : std::uint8_t { none, contacts, energy };
  // What sets a step, in numbers.
  struct Limit {
    Cause cause = Cause::cables;
    StepLimit mode = StepLimit::nothing;
    std::int32_t thread = 0;
    Shortening shortening = Shortening::none;
  };

  void find_rope_step(double length);
  StableStep present_bound() const;
  double part_left();
  double expected(double left);
  Shortening shortening() const;

  CableSystem& system_;
  const Model& model_;
  StableStep bound_;                                    // of straight cables, at the rope length:
  double bound_length_;                                 // m
  int length_class_ = std::numeric_limits<int>::max();  // for which rope_step_ holds
  double rope_step_ = 0;                                // s
  double left_ = 1;                                     // part of the bound that the last choice took as left by bends
  double least_left_ = 1, most_left_ = 1;               // that seen at the last choice and since
  bool watches_ = false;                                // each step, until the next choice
  Cause cause_ = Cause::cables;                         // of the last choice
  StepCaution caution_;
  double smallest_step_ = std::numeric_limits<double>::infinity();
  Limit smallest_;
};

}  // namespace netpocket
