#include "engine/dynamics/system/element_states.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "engine/ancf/mean_strain_element.h"
#include "engine/ancf/strain_pair.h"

namespace netpocket {
namespace {

// Number of elements that a thread processes at once and whose energies it sums in sequence. Constant and a multiple of
// the block size, so that sums do not depend on the number of threads.
constexpr int kElementRange = 2048;

// Row numbers in the results of ElementBatch::states.
constexpr std::size_t kStrain = 0, kStrainRate = 1, kBendingEnergy = 2, kBendStiffness = 3;

}  // namespace

void ElementStates::refresh() {
  if (version_ == state_.version) return;
  version_ = state_.version;
  const ElementBatch& batch = elements_.batch();
  rows_.resize(static_cast<std::size_t>(batch.block_count()) * kStateRows * kBlockSize);
  threads_.loop()(batch.block_count(), kElementRange / kBlockSize, [&](int first, int last) {
    batch.states(first, last, state_.coordinates.rows(), state_.velocities.rows(), rows_.data());
  });
}

// By lane.
const double* ElementStates::row(int block, std::size_t row) const {
  return rows_.data() + (static_cast<std::size_t>(block) * kStateRows + row) * kBlockSize;
}

double ElementStates::value(std::size_t element, std::size_t of_row) const {
  return row(static_cast<int>(element / kBlockSize), of_row)[element % kBlockSize];
}

// The value of a row that determines an element's tension: its own, or the paired one with its strain partner.
double ElementStates::resisted(std::size_t element, std::size_t of_row) const {
  const std::int32_t strain_partner = elements_.is_full() ? -1 : model_.elements[element].strain_partner;
  const double own = value(element, of_row);
  return strain_partner < 0 ? own : paired_strain(own, value(static_cast<std::size_t>(strain_partner), of_row));
}

// The strain and tension of the full element, which differ from what the mean-strain kernel finds.
FullElement::Stretching ElementStates::stretching(std::size_t element) const {
  return FullElement(elements_.section(element), elements_.span(element))
      .stretching(elements_.gather(state_.coordinates, element), elements_.gather(state_.velocities, element));
}

double ElementStates::tension(std::size_t element) const {
  if (elements_.is_full()) return stretching(element).tension;
  const CableSection& section = elements_.section(element);
  const double strain = resisted(element, kStrain);
  return section.axial_stiffness(strain) * (strain + section.axial_damping * resisted(element, kStrainRate));
}

double ElementStates::strain(std::size_t element) const {
  return elements_.is_full() ? stretching(element).strain : value(element, kStrain);
}

// J, of elements [first, last).
double ElementStates::energy_of(std::size_t first, std::size_t last) const {
  double energy = 0;
  for (std::size_t i = first; i < last; ++i) {
    const CableSection& section = elements_.section(i);
    if (elements_.is_full()) {
      const ElementCoordinates q = elements_.gather(state_.coordinates, i);
      const FullElement element(section, elements_.span(i));
      energy += element.axial_energy(q) + element.bending_energy(q);
    } else {
      const double strain = resisted(i, kStrain);
      const double stiffness = section.axial_stiffness(strain) * elements_.lengths()[i];
      energy += 0.5 * stiffness * strain * value(i, kStrain) + value(i, kBendingEnergy);
    }
  }
  return energy;
}

double ElementStates::strain_energy() const {
  const auto parts = values_of_ranges<double>(threads_.loop(), static_cast<int>(model_.elements.size()), kElementRange,
                                              [&](int first, int last) { return energy_of(first, last); });
  return std::accumulate(parts.begin(), parts.end(), 0.0);
}

double ElementStates::rope_tension(std::int32_t rope) const {
  const VariableRope& cord = model_.ropes[static_cast<std::size_t>(rope)];
  const std::size_t count = cord.elements.size();
  double sum = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const auto element = static_cast<std::size_t>(cord.elements[i]);
    const CableSection& section = elements_.section(element);
    const MaterialSpan span = rope_span(elements_.ropes().motion(rope), cord.share_at_start, i, count);
    const ElementCoordinates q = elements_.gather(state_.coordinates, element),
                             v = elements_.gather(state_.velocities, element);
    sum += elements_.is_full() ? FullElement(section, span).stretching(q, v).tension
                               : MeanStrainElement(section, span).tension(q, v);
  }
  return sum / static_cast<double>(count);
}

void ElementStates::rope_tensions(std::span<double> tensions) const {
  if (!elements_.is_full()) return elements_.ropes().mean_tensions(state_.coordinates, state_.velocities, tensions);
  for (std::size_t rope = 0; rope < tensions.size(); ++rope) {
    tensions[rope] = rope_tension(static_cast<std::int32_t>(rope));
  }
}

double ElementStates::stable_step(const StableStep& straight) {
  if (elements_.is_full()) return stable_step_of_full(straight);
  refresh();
  return stable_step_of_mean_strain(straight);
}

// Two effects raise the frequencies above those of straight cables.
// - Bends: stretching also acts on the gradients of a bent element, and the two elements of a pair no longer cancel
//   where they meet at an angle. Let K_1 and K_2 have the largest squared frequencies l_1 and l_2. Then K_1 + K_2 has
//   (l_1 + l_2)/2 + sqrt((l_1 - l_2)^2/4 + o l_1 l_2), where o <= 1 is the overlap of the two modes. Power iteration on
//   shapes of captures gives o = 0.03 for paired elements, with l_2 as large as it is taken here. Elements without a
//   strain partner get o = 1: a bent one vibrates as a whole.
// - Tension: at strain eps the Green strain's stiffness along a cord is EA (1 + 2 eps) + N = EA (1 + 3 eps).
double ElementStates::stable_step_of_mean_strain(const StableStep& straight) const {
  struct Largest {
    double of_bends = 0, of_unpaired = 0, strain = 0;
  };
  using Row = Eigen::Array<double, kBlockSize, 1>;
  const auto largest = [&](int first, int last) {
    Row of_bends = Row::Zero(), of_unpaired = Row::Zero(), strain = Row::Zero();
    for (int block = first; block < last; ++block) {
      const Eigen::Map<const Row> rate(elements_.wave_rates(block));  // 0: no element
      const Eigen::Map<const Row> unpaired(elements_.unpaired_rates(block));
      const Eigen::Map<const Row> bend(row(block, kBendStiffness));
      of_bends = of_bends.max(rate * bend);
      of_unpaired = of_unpaired.max(unpaired * bend);
      strain = strain.max((rate > 0).select(Eigen::Map<const Row>(row(block, kStrain)), 0.0));
    }
    return Largest{of_bends.maxCoeff(), of_unpaired.maxCoeff(), strain.maxCoeff()};
  };
  double of_bends = 0, of_unpaired = 0, strain = 0;
  for (const Largest& part : values_of_ranges<Largest>(threads_.loop(), elements_.batch().block_count(),
                                                       kElementRange / kBlockSize, largest)) {
    of_bends = std::max(of_bends, part.of_bends);
    of_unpaired = std::max(of_unpaired, part.of_unpaired);
    strain = std::max(strain, part.strain);
  }
  const double bent = of_bends / straight.stiffness;
  // At 1 the bound is sure. Cords strained by more than some percent need that.
  const double overlap = std::clamp(10 * strain - 0.5, 0.25, 1.0);
  const double paired = 0.5 * (1 + bent + std::sqrt((1 - bent) * (1 - bent) + 4 * overlap * bent));
  const double together = std::max(paired, 1 + of_unpaired / straight.stiffness);
  // Damping of stretching grows in proportion to its stiffness.
  const double ratio = together + 3 * strain;
  return stable_step_of_mode(straight.stiffness * ratio, straight.damping * ratio);
}

// The axial stiffness at a point is EA a a^T + N I with a = r'. It is at most (1 + 3 eps) EA at Green strain eps. So
// the squared frequencies, of bent elements too, grow by at most this factor, and so does damping.
double ElementStates::stable_step_of_full(const StableStep& straight) const {
  const auto largest = [&](int first, int last) {
    double strain = 0;
    for (int i = first; i < last; ++i) strain = std::max(strain, stretching(i).largest_strain);
    return strain;
  };
  double strain = 0;
  for (const double part :
       values_of_ranges<double>(threads_.loop(), static_cast<int>(model_.elements.size()), kElementRange, largest)) {
    strain = std::max(strain, part);
  }
  const double ratio = 1 + 3 * strain;
  return stable_step_of_mode(straight.stiffness * ratio, straight.damping * ratio);
}

}  // namespace netpocket
