#include "engine/dynamics/stepping/step_limiter.h"

#include <utility>

namespace netpocket {
namespace {

// Penetrations (m): steps are shortened above kDeep. A run is given up above kDeepest if its steps are already the
// shortest.
constexpr double kDeep = 0.02, kDeepest = 0.05;
// Factor on the steps after an interval with deep contacts. It makes penetrations 0.55 times as deep.
constexpr double kShortening = 0.7;
constexpr double kLeastForContacts = 0.02;

// Largest aliased energy, as a fraction of the exchanged one.
constexpr double kAliased = 0.004;
// Steps grow by kGrowth at each output interval while the aliased energy is below kWellResolved of that limit.
constexpr double kWellResolved = 0.1, kGrowth = 1.05;
constexpr double kLeastForEnergy = 0.25;
// Exchanged energies (J) below this are round-off.
constexpr double kLeastEnergy = 1e-6;

}  // namespace

void StepLimiter::follow_contacts() {
  const double deepest = std::exchange(deepest_, 0.0);
  const bool exhausted = for_contacts_ <= kLeastForContacts;
  overload_ = exhausted && deepest > kDeepest ? deepest : 0;
  if (deepest > kDeep) for_contacts_ = std::max(kLeastForContacts, kShortening * for_contacts_);
  if (deepest < care_.shallow) for_contacts_ = std::min(1.0, for_contacts_ / kShortening);
}

void StepLimiter::note_unresolved_contacts() {
  for_contacts_ = std::max(kLeastForContacts, care_.after_unresolved * for_contacts_);
}

// The aliased energy is proportional to the square of the step.
void StepLimiter::anticipate_energy(double aliased, double exchanged) {
  const double limit = kAliased * std::max(exchanged, kLeastEnergy);
  while (aliased * for_energy_ * for_energy_ > limit && for_energy_ > kLeastForEnergy) for_energy_ *= 0.5;
}

// The aliased energy oscillates with the waves, so steps grow back slowly.
void StepLimiter::follow_energy(double aliased, double exchanged) {
  const double limit = kAliased * std::max(exchanged, kLeastEnergy);
  if (aliased > limit) for_energy_ = std::max(kLeastForEnergy, 0.5 * for_energy_);
  if (aliased < kWellResolved * limit) for_energy_ = std::min(1.0, kGrowth * for_energy_);
}

void StepLimiter::visit_state(const std::function<void(double&)>& visit) {
  for (double* value : {&deepest_, &for_contacts_, &for_energy_, &overload_}) visit(*value);
}

}  // namespace netpocket
