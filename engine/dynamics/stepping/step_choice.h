#pragma once
// Chooses the integration step of a pocket while its closing ropes shorten and its cords bend, and tells what limits
// it.
//
// The stable step of straight cables is the smaller of two bounds:
// - Of the whole model (stable_step.h). Shorter closing ropes hold the rods' tips more stiffly, so it is computed again
//   each time the ropes are 15 % shorter.
// - Of one element of a closing rope by itself, at its present length.
//
// Bends and tensions stiffen the cables. They multiply this step by `bend_factor` (at most 1), which is computed at
// each choice, and after each step while it varies by more than 3 %. StepLimiter multiplies the result where stability
// alone is not enough.
//
// Thread contract: one thread at a time.

#include <functional>
#include <limits>
#include <string>

#include "engine/dynamics/assembly/stable_step.h"
#include "engine/dynamics/stepping/step_limiter.h"
#include "engine/dynamics/system/cable_system.h"
#include "engine/model/model.h"

namespace netpocket {

class StepChoice {
 public:
  // `system`: as built; must outlive this object. Its closing ropes must all be alike.
  explicit StepChoice(CableSystem& system);

  // Largest step (s, without a safety factor) that is stable from the system's present time until `end` (s), if the
  // ropes are wound by this law. Includes the factor of the limiter.
  double stable_step(const std::function<RopeMotion(double)>& winding, double end);
  // To be called after a step. Whether a step of this size (s) is no longer stable in the system's present shape.
  // Always false while bend_factor is steady.
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
    std::int32_t thread = 0;
    Shortening shortening = Shortening::none;
  };

  void find_rope_step(double length);
  StableStep straight_bound() const;
  double bend_factor();
  double anticipation(double factor);
  Shortening shortening() const;

  CableSystem& system_;
  const Model& model_;
  StableStep bound_;                                    // of straight cables at rope length bound_length_
  double bound_length_;                                 // m
  int length_class_ = std::numeric_limits<int>::max();  // rope length for which rope_step_ holds, as a power of 1.01
  double rope_step_ = 0;                                // s, stable step of one element of the closing ropes
  double last_factor_ = 1;                              // bend_factor used by the last choice
  double smallest_factor_ = 1, largest_factor_ = 1;     // of bend_factor since the last choice
  bool is_monitored_ = false;                           // whether bend_factor is computed after each step
  Cause cause_ = Cause::cables;                         // of the last choice
  StepLimiter limiter_;
  double smallest_step_ = std::numeric_limits<double>::infinity();
  Limit smallest_;
};

}  // namespace netpocket
