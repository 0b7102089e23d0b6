#pragma once
// Chooses the integration step of a system while its wound ropes shorten and its cords bend, and tells what limits it.
//
// The stable step of straight cables is the smaller of two bounds:
// - Of the whole model (stable_step.h). Shorter ropes hold their ends more stiffly, so it is computed again each time
//   the length of a rope has changed by 15 %.
// - Of one element of a wound rope by itself, at the shortest length that it is expected to have until the next choice.
//   If a rope becomes shorter than that, the step is outgrown.
//
// Bends and tensions stiffen the cables. They multiply this step by `bend_factor` (at most 1), which is computed at
// each choice, and after each step while it varies by more than 3 %. StepLimiter multiplies the result where stability
// alone is not enough.
//
// Thread contract: one thread at a time.

#include <functional>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "engine/dynamics/assembly/stable_step.h"
#include "engine/dynamics/stepping/step_limiter.h"
#include "engine/dynamics/system/cable_system.h"
#include "engine/model/model.h"

namespace netpocket {

class StepChoice {
 public:
  // `system`: as built; must outlive this object.
  explicit StepChoice(CableSystem& system);

  // Largest step (s, without a safety factor) that is stable in the system's present shape as long as no rope becomes
  // shorter than `shortest` (m, by rope). Includes the factor of the limiter.
  double stable_step(std::span<const double> shortest);
  // To be called after a step. Whether a step of this size (s) is no longer stable in the system's present shape.
  bool is_outgrown(double step);
  StepLimiter& limiter() { return limiter_; }
  const StepLimiter& limiter() const { return limiter_; }

  // s, of the system at rest, before any choice.
  double first_stable_step() const { return bound_.step; }

  // Notes that the last choice has led to a step of this size (s).
  void note(double step);
  // Smallest step noted (s); infinite before the first.
  double smallest_step() const { return smallest_step_; }
  // What limited the smallest step, e.g. "axial waves in panel 3 row 2, and bends of cords".
  std::string limit() const;

  // Gives every number of the state to `visit`, which may change it.
  void visit_state(const std::function<void(double&)>& visit);

 private:
  enum class Cause : std::uint8_t { cables, bends, ropes };
  enum class Shortening : std::uint8_t { none, contacts, energy };
  // Cause of a step, as numbers.
  struct Limit {
    Cause cause = Cause::cables;
    StepLimit mode = StepLimit::nothing;
    std::int32_t thread = 0;  // of the cable that limits the step; for Cause::ropes the index of the rope
    Shortening shortening = Shortening::none;
  };

  // The stable step of one element of a wound rope. It holds for a range of lengths.
  struct RopeBound {
    double length_at_bound = 0;                          // m, length of the rope for which bound_ was computed
    int length_class = std::numeric_limits<int>::max();  // element length, rounded down to a power of 1.01
    double shortest = 0;                                 // m, least length of the rope for which `step` holds
    double step = 0;                                     // s
    double above = 1, below = 0;  // m, element lengths between these are surely of this class; none yet
  };

  double length_of(std::size_t rope) const;
  bool lengths_have_changed() const;
  bool is_shorter_than_expected() const;
  int class_of(double length);
  void find_rope_step(std::size_t rope, double length);
  bool is_like_previous(std::size_t rope) const;
  StableStep straight_bound() const;
  std::string rope_limit(std::int32_t rope) const;
  double bend_factor();
  double anticipation(double factor);
  Shortening shortening() const;

  CableSystem& system_;
  const Model& model_;
  StableStep bound_;                                            // of straight cables
  std::vector<RopeBound> ropes_;                                // by rope of the model
  double rope_step_ = std::numeric_limits<double>::infinity();  // s, least step of ropes_
  std::int32_t limiting_rope_ = 0;                              // the rope with that step
  double classified_length_ = 0;                                // m, last argument of class_of
  int length_class_ = 0;                                        // its class
  double last_factor_ = 1;                                      // bend_factor used by the last choice
  double smallest_factor_ = 1, largest_factor_ = 1;             // of bend_factor since the last choice
  bool is_monitored_ = false;                                   // whether bend_factor is computed after each step
  Cause cause_ = Cause::cables;                                 // of the last choice
  StepLimiter limiter_;
  double smallest_step_ = std::numeric_limits<double>::infinity();
  Limit smallest_;
};

}  // namespace netpocket
