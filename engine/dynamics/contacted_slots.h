#pragma once
// The nodes and gradients that contacts act on in a step: how many contacts share them, and the velocities that all
// other forces of the step lead to.
//
// All contacts of a step are computed from the same state (Jacobi-wise). Where a contact is solved for its own speed
// (damping, friction, springs too stiff for the step), those that share nodes must share the nodes' inertia too: a
// contact's inverse mass counts every contact point on its nodes, w = sum_i |S_i| (sum_c |S_i,c|)/m_i, the row sum of
// the contacts' common inverse mass matrix. No step can then push a node beyond what a single contact would (mass
// splitting: Tonge, Benevolenski & Voroshilov 2012, doi:10.1145/2185520.2185601).

#include <cmath>
#include <span>
#include <vector>

#include "engine/dynamics/element_curve.h"
#include "engine/dynamics/slot_state.h"

namespace netpocket {

class ContactedSlots {
 public:
  explicit ContactedSlots(std::int32_t slots)
      : shared_weight_(static_cast<std::size_t>(slots), 0.0), predicted_(slots) {}

  // Begins a step.
  void clear() {
    for (const std::int32_t slot : slots_) shared_weight_[slot] = 0;
    slots_.clear();
  }
  // A contact acts on `slot` with this weight.
  void share(std::int32_t slot, double weight) {
    if (shared_weight_[slot] == 0) slots_.push_back(slot);
    shared_weight_[slot] += std::abs(weight);
  }
  const std::vector<std::int32_t>& slots() const { return slots_; }

  // Velocities after a step of `dt` (s) under `force(slot)`, which is everything but contact.
  template <typename Force>
  void predict(const SlotVectors& velocities, std::span<const double> inverse_mass, double dt, const Force& force) {
    for (const std::int32_t slot : slots_) {
      predicted_.set(slot, velocities.get(slot) + (dt * inverse_mass[slot]) * force(slot));
    }
  }
  const SlotVectors& predicted() const { return predicted_; }

  // A contact's part of the slots' inverse mass, 1/kg.
  double inverse_mass(const ElementSlots& slot, const ElementWeights& weight,
                      std::span<const double> inverse_mass) const {
    double sum = 0;
    for (std::size_t i = 0; i < 4; ++i) sum += std::abs(weight[i]) * shared_weight_[slot[i]] * inverse_mass[slot[i]];
    return sum;
  }

 private:
  std::vector<double> shared_weight_;  // by slot, sum of contact weights
  SlotVectors predicted_;
  std::vector<std::int32_t> slots_;
};

}  // namespace netpocket
