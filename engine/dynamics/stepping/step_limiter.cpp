#include "engine/dynamics/stepping/step_limiter.h"

#include <utility>

namespace netpocket {
namespace {

// Penetrations (m): steps are shortened above kDeep, unless stiffer springs are compressed by less than kShallow, and
// grow again below kShallow. A run is given up above kDeepest if its steps are already the shortest.
constexpr double kDeep = 0.015, kShallow = 0.004, kDeepest = 0.05;
// Factor on the steps after an interval with deep contacts. With the springs that shorter steps allow, penetrations
// become a third as deep.
constexpr double kShortening = 0.35;
constexpr double kLeastForContacts = 0.02;
// Steps grow also where springs bear less than this part of what the softest ones bear. Contacts may then still be
// deep, because stiffer springs begin where the softer ones were. After grow_under_loads, the springs of the longer
// steps count instead. What springs bear at their greatest depth grows with their stiffness, which is inversely
// proportional to the square of the step. Above kDeep the softest springs count there too: each change between soft and
// stiff springs presses a loaded cord deeper.
constexpr double kBorne = 0.2;
// Largest squared phase of a spring in a step (force_law.h) with which steps grow again, and the factor by which.
constexpr double kWellResolvedPhase = 0.5, kLengthening = 1.4;

// Largest aliased energy, as a fraction of the exchanged one.
constexpr double kAliased = 0.004;
// Steps grow by kGrowth at each output interval while the aliased energy is below kWellResolved of that limit.
constexpr double kWellResolved = 0.1, kGrowth = 1.05;
constexpr double kLeastForEnergy = 0.25;
// Exchanged energies (J) below this are round-off.
constexpr double kLeastEnergy = 1e-6;

}  // namespace

void StepLimiter::note_blow() {
  for_load_ = std::max(kLeastForContacts, 0.5 * for_load_);
  has_blow_ = true;
}

bool StepLimiter::note_squared_phase(double squared_phase) {
  largest_squared_phase_ = std::max(largest_squared_phase_, squared_phase);
  if (!(squared_phase > 1)) return true;
  for_springs_ = std::max(kLeastForContacts, 0.5 * for_springs_);
  return false;
}

void StepLimiter::follow_contacts() {
  const double deepest = std::exchange(deepest_, 0.0), load = std::exchange(load_, kUnknown);
  const double compression = std::exchange(compression_, kUnknown);
  const bool has_blow = std::exchange(has_blow_, false), exhausted = for_load_ <= kLeastForContacts;
  const double longer = std::min(1.0, for_load_ / kShortening);
  const double part = grows_under_loads_ && deepest < kDeep ? longer * longer : 1;
  overload_ = exhausted && deepest > kDeepest ? deepest : 0;
  if (deepest > kDeep && compression > kShallow) {
    for_load_ = std::max(kLeastForContacts, kShortening * for_load_);
  } else if (deepest < kShallow || (!has_blow && part * load < kBorne)) {
    for_load_ = longer;
  }
  const double next_squared_phase = kLengthening * kLengthening * std::exchange(largest_squared_phase_, 0.0);
  if (next_squared_phase < kWellResolvedPhase) for_springs_ = std::min(1.0, kLengthening * for_springs_);
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
  for (double* value : {&deepest_, &largest_squared_phase_, &load_, &compression_, &for_load_, &for_springs_,
                        &for_energy_, &overload_}) {
    visit(*value);
  }
  double has_blow = has_blow_ ? 1 : 0;
  visit(has_blow);
  has_blow_ = has_blow != 0;
}

}  // namespace netpocket
