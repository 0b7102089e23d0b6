#pragma once
// The part of the stable step that a run makes use of when stability is not enough:
// - Contacts are no stiffer than steps resolve (force_law.h), so loads press cords the deeper the longer the steps are,
//   with dt^(5/3). Deeper than kDeep, steps are shortened until contacts are stiff enough.
// - Waves whose period is a few steps keep their own energy, not the true one: the account of energy misses the part
//   (w dt/2)^2 of theirs. Where that is more than kUnresolved of what has changed hands, steps are shortened.
// Ordinary captures do neither: penetrations stay below 4 mm.
//
// Follows what it is told step by step, at times that do not depend on who looks at the run.

#include <algorithm>
#include <functional>

namespace netpocket {

class StepCaution {
 public:
  // Deepest penetration (m) of a contact with a body in a step.
  void note_penetration(double depth) { deepest_ = std::max(deepest_, depth); }
  // After a step in which blows were stopped at the greatest depth of contacts, or springs of contacts were too stiff
  // for it (contact_solver.h). Halves the steps at once.
  void note_unresolved_contacts();
  // At the end of a stretch of equal steps, of 0.01 s at most.
  void follow_contacts();
  // At the start, of steps of the size that stability allows: what follow_energy is told later.
  void foresee_energy(double unresolved, double changed_hands);
  // At the end of an output interval: the energy (J) that the steps do not resolve and that which has changed hands.
  void follow_energy(double unresolved, double changed_hands);

  // At most 1; the stable step is to be multiplied by it.
  double part() const { return std::min(for_contacts_, for_energy_); }
  bool is_for_contacts() const { return for_contacts_ <= for_energy_; }
  // Deepest penetration (m) of the last stretch if the shortest steps did not prevent a depth beyond all bounds; else
  // 0.
  double overload() const { return overload_; }

  // Gives every number of the state to `visit`, which may change it.
  void visit_state(const std::function<void(double&)>& visit);

 private:
  double deepest_ = 0;  // m, of this stretch
  double for_contacts_ = 1, for_energy_ = 1;
  double overload_ = 0;  // m
};

}  // namespace netpocket
