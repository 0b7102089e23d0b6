#pragma once
// Shortens steps where stability is not enough, by a factor on the stable step:
// - Load. A load for which springs of contacts are too soft presses cords to their greatest depth, where each step
//   stops the approach (contact_solver.h). Steps are halved after a stop, and shortened while penetrations exceed kDeep
//   and springs are compressed by more than kShallow. Shorter steps let springs be stiffer. They grow again when the
//   load has gone.
// - Springs. Steps are halved while a spring is too stiff for them, which creates energy. Springs do not follow these
//   shorter steps.
// - Short waves. The integrator misses the part (w dt/2)^2 of the energy of a wave of frequency w (aliased energy).
//   Steps are shortened while that exceeds kAliased of the energy that has been exchanged.
//
// Ordinary captures need none of it: penetrations stay below 4 mm.
//
// Its decisions depend only on what it is told step by step, not on when a run is observed.

#include <algorithm>
#include <functional>
#include <limits>

namespace netpocket {

class StepLimiter {
 public:
  // Deepest penetration (m) of cords into bodies in the step just made.
  void note_penetration(double depth) { deepest_ = std::max(deepest_, depth); }
  // To be called after a step in which contacts were stopped at their greatest depth. Halves the next steps.
  void note_blow();
  // Lets steps grow under a load that stays, as far as springs of the longer steps bear it. Faster, and less accurate:
  // springs that change under a load cost some of its energy.
  void grow_under_loads() { grows_under_loads_ = true; }
  // Whether springs are stiffer than usual because of a load. note_springs is then to be told what they bear.
  bool is_for_load() const { return for_load_ < 1; }
  // Largest force of a spring in the step just made by what the softest springs bear, and largest compression (m).
  void note_springs(double load, double compression) {
    load_ = load_ < kUnknown ? std::max(load_, load) : load;
    compression_ = compression_ < kUnknown ? std::max(compression_, compression) : compression;
  }
  // Largest squared phase of a contact's spring in the step just made. If the spring is too stiff, halves the next
  // steps and returns false.
  bool note_squared_phase(double squared_phase);
  // To be called at the end of an interval of equal steps, 0.01 s at most.
  void follow_contacts();
  // To be called once before the first step, with the energies (J) that follow_energy would get for the stable step.
  void anticipate_energy(double aliased, double exchanged);
  // To be called at the end of an output interval, with the aliased and the exchanged energy (J).
  void follow_energy(double aliased, double exchanged);

  // Factor on the stable step, at most 1.
  double factor() const { return std::min(spring_factor(), for_springs_); }
  // The factor for the steps that springs are fitted to. If they followed the steps that are shortened because of them,
  // they would remain too stiff.
  double spring_factor() const { return std::min(for_load_, for_energy_); }
  bool is_for_contacts() const { return std::min(for_load_, for_springs_) <= for_energy_; }
  // Deepest penetration (m) of the last interval if it exceeded the bound although steps are as short as they get; else
  // 0.
  double overload() const { return overload_; }

  // Gives every number of the state to `visit`, which may change it.
  void visit_state(const std::function<void(double&)>& visit);

 private:
  static constexpr double kUnknown = std::numeric_limits<double>::infinity();

  double deepest_ = 0;                               // m, of this interval
  double largest_squared_phase_ = 0;                 // of this interval
  double load_ = kUnknown, compression_ = kUnknown;  // likewise
  bool has_blow_ = false;                            // likewise
  double for_load_ = 1, for_springs_ = 1, for_energy_ = 1;
  bool grows_under_loads_ = false;  // not of the state: a setting
  double overload_ = 0;             // m
};

}  // namespace netpocket
