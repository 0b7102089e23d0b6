#include "engine/dynamics/step_caution.h"

#include <utility>

namespace netpocket {
namespace {

// Penetrations (m) above which steps are shortened, below which they grow again, and beyond which a contact that the
// shortest steps have not stiffened enough is none.
constexpr double kDeep = 0.02, kShallow = 0.004, kDeepest = 0.05;
// The step after a stretch of deep contacts, in terms of that before it: penetrations become 0.55 times as deep.
constexpr double kShortening = 0.7;
constexpr double kLeastForContacts = 0.1;

// Of the energy that has changed hands.
constexpr double kUnresolved = 0.004;
// Of that, below which steps grow again, and by how much at each output interval.
constexpr double kMuchResolved = 0.1, kGrowth = 1.05;
constexpr double kLeastForEnergy = 0.25;
// Less (J) than this is rounding.
constexpr double kLeastEnergy = 1e-6;

}  // namespace

void StepCaution::follow_contacts() {
  const double deepest = std::exchange(deepest_, 0.0);
  const bool exhausted = for_contacts_ <= kLeastForContacts;
  overload_ = exhausted && deepest > kDeepest ? deepest : 0;
  if (deepest > kDeep) for_contacts_ = std::max(kLeastForContacts, kShortening * for_contacts_);
  if (deepest < kShallow) for_contacts_ = std::min(1.0, for_contacts_ / kShortening);
}

void StepCaution::note_unresolved_contacts() { for_contacts_ = std::max(kLeastForContacts, 0.5 * for_contacts_); }

// It goes with the square of the step.
void StepCaution::foresee_energy(double unresolved, double changed_hands) {
  const double limit = kUnresolved * std::max(changed_hands, kLeastEnergy);
  while (unresolved * for_energy_ * for_energy_ > limit && for_energy_ > kLeastForEnergy) for_energy_ *= 0.5;
}

// The energy not resolved comes and goes with the waves: steps grow again slowly.
void StepCaution::follow_energy(double unresolved, double changed_hands) {
  const double limit = kUnresolved * std::max(changed_hands, kLeastEnergy);
  if (unresolved > limit) for_energy_ = std::max(kLeastForEnergy, 0.5 * for_energy_);
  if (unresolved < kMuchResolved * limit) for_energy_ = std::min(1.0, kGrowth * for_energy_);
}

void StepCaution::visit_state(const std::function<void(double&)>& visit) {
  for (double* value : {&deepest_, &for_contacts_, &for_energy_, &overload_}) visit(*value);
}

}  // namespace netpocket
