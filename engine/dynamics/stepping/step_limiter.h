#pragma once
// Shortens steps where stability is not enough, by a factor on the stable step:
// - Contacts. A load for which springs of contacts are too soft presses cords to their greatest depth, where each step
//   stops the approach (contact_solver.h). Steps are halved after a stop and shortened while penetrations exceed kDeep.
//   They grow again as soon as the springs can bear their load in longer steps. What counts is how far springs are
//   compressed, not how deep cords lie: a spring that became stiffer in a contact begins below the surface.
// - Short waves. The integrator misses the part (w dt/2)^2 of the energy of a wave of frequency w (aliased energy).
//   Steps are shortened while that exceeds kAliased of the energy that has been exchanged.
//
// Ordinary captures need neither: penetrations stay below 4 mm.
//
// Its decisions depend only on what it is told step by step, not on when a run is observed.

#include <algorithm>
#include <functional>

namespace netpocket {

class StepLimiter {
 public:
  // Ratio by which steps grow from one interval to the next.
  static constexpr double kContactGrowth = 1 / 0.7;

  // Deepest penetration (m) of cords into bodies in the step just made, and the largest compression of their springs.
  void note_contacts(double depth, double compression);
  // To be called after a step in which contacts were stopped at their greatest depth or had springs too stiff for the
  // step (contact_solver.h). Halves the next steps.
  void note_unresolved_contacts();
  // To be called at the end of an interval of equal steps, 0.01 s at most. `keeps_springs`: whether springs stay as
  // stiff as they are in steps longer by kContactGrowth.
  void follow_contacts(bool keeps_springs);
  // To be called once before the first step, with the energies (J) that follow_energy would get for the stable step.
  void anticipate_energy(double aliased, double exchanged);
  // To be called at the end of an output interval, with the aliased and the exchanged energy (J).
  void follow_energy(double aliased, double exchanged);

  // Factor on the stable step, at most 1.
  double factor() const { return std::min(for_contacts_, for_energy_); }
  bool is_for_contacts() const { return for_contacts_ <= for_energy_; }
  // Deepest penetration (m) of the last interval if it exceeded the bound although steps are as short as they get; else
  // 0.
  double overload() const { return overload_; }

  // Gives every number of the state to `visit`, which may change it.
  void visit_state(const std::function<void(double&)>& visit);

 private:
  double deepest_ = 0;  // m, of this interval
  double for_contacts_ = 1, for_energy_ = 1;
  double overload_ = 0;  // m
};

}  // namespace netpocket
