#include "engine/dynamics/stepping/step_limiter.h"

#include <utility>

namespace netpocket {
namespace {

// Penetrations (m): steps are shortened above kDeep. A run is given up above kDeepest if its steps are already the
// shortest.
constexpr double kDeep = 0.02, kDeepest = 0.05;
// Once steps are shortened, they are shortened further while springs are compressed more than kTight (m), and grow
// again while springs will be compressed less than kLoose.
constexpr double kTight = 0.002, kLoose = 0.0015;
// Springs for steps twice as long are softer by 2^2.5. Under the same load they are compressed 2^(5/3) times as far.
constexpr double kSinking = 3.1748;
// Factor on the steps after an interval with deep contacts. It makes penetrations 0.55 times as deep.
constexpr double kShortening = 1 / StepLimiter::kContactGrowth;
constexpr double kLeastForContacts = 0.02;

// Largest aliased energy, as a fraction of the exchanged one.
constexpr double kAliased = 0.004;
// Steps grow by kGrowth at each output interval while the aliased energy is below kWellResolved of that limit.
constexpr double kWellResolved = 0.1, kGrowth = 1.05;
constexpr double kLeastForEnergy = 0.25;
// Exchanged energies (J) below this are round-off.
constexpr double kLeastEnergy = 1e-6;

}  // namespace

void StepLimiter::note_contacts(double depth, double compression) {
  deepest_ = std::max(deepest_, depth > kDeep ? depth : std::min(depth, compression));
}

void StepLimiter::follow_contacts(bool keeps_springs) {
  const double deepest = std::exchange(deepest_, 0.0);
  const bool exhausted = for_contacts_ <= kLeastForContacts;
  overload_ = exhausted && deepest > kDeepest ? deepest : 0;
  if (deepest > (for_contacts_ < 1 ? kTight : kDeep))
    for_contacts_ = std::max(kLeastForContacts, kShortening * for_contacts_);
  if ((keeps_springs ? deepest : kSinking * deepest) < kLoose) {
    for_contacts_ = std::min(1.0, for_contacts_ / kShortening);
  }
}

// Steps do not grow in this interval.
void StepLimiter::note_unresolved_contacts() {
  for_contacts_ = std::max(kLeastForContacts, 0.5 * for_contacts_);
  deepest_ = std::max(deepest_, 0.5 * (kTight + kLoose));
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
