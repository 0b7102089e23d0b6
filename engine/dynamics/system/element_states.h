#pragma once
// Strains, tensions and energies of the elements at the present state, and the step that these allow. Computed when
// they are asked for. Internal to this room.

#include "engine/ancf/full_element.h"
#include "engine/base/aligned_vector.h"
#include "engine/dynamics/assembly/stable_step.h"
#include "engine/dynamics/system/cable_elements.h"
#include "engine/dynamics/system/cable_state.h"
#include "engine/dynamics/system/system_threads.h"

namespace netpocket {

class ElementStates {
 public:
  // All must outlive this object.
  ElementStates(const Model& model, const CableElements& elements, const CableState& state,
                const SystemThreads& threads)
      : model_(model), elements_(elements), state_(state), threads_(threads) {}

  // Brings all values to the present state. To be called before the next three functions.
  void refresh();
  double tension(std::size_t element) const;  // N
  double strain(std::size_t element) const;
  double strain_energy() const;  // J, of all elements

  // Mean tension (N) of a rope's elements, at the rope's present motion. Needs no refresh.
  double rope_tension(std::int32_t rope) const;
  // The same of the first ropes, equal to round-off.
  void rope_tensions(std::span<double> tensions) const;

  // As CableSystem::stable_step_as_bent. Brings the values to the present state.
  double stable_step(const StableStep& straight);

 private:
  const double* row(int block, std::size_t row) const;
  double value(std::size_t element, std::size_t row) const;
  double resisted(std::size_t element, std::size_t row) const;
  double energy_of(std::size_t first, std::size_t last) const;
  FullElement::Stretching stretching(std::size_t element) const;
  double stable_step_of_mean_strain(const StableStep& straight) const;
  double stable_step_of_full(const StableStep& straight) const;

  const Model& model_;
  const CableElements& elements_;
  const CableState& state_;
  const SystemThreads& threads_;
  AlignedVector<double> rows_;  // as ElementBatch::states writes them
  std::int64_t version_ = -1;   // of the state that they are for
};

}  // namespace netpocket
