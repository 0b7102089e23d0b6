#include <algorithm>

#include "engine/dynamics/system/cable_system_impl.h"

namespace netpocket {

// The strain and tension of the full element, which differ from what the mean-strain kernel finds.
FullElement::Stretching CableSystem::Impl::full_stretching(std::size_t element) const {
  const CableSection& section = model.material_of(static_cast<std::int32_t>(element)).section;
  return FullElement(section, span(element)).stretching(gather(coordinates, element), gather(velocities, element));
}

// The axial stiffness at a point is EA a a^T + N I with a = r'. It is at most (1 + 3 eps) EA at Green strain eps. So
// the squared frequencies, of bent elements too, grow by at most this factor, and so does damping.
double CableSystem::Impl::stable_step_as_stretched(const StableStep& straight) {
  const auto largest = [&](int first, int last) {
    double strain = 0;
    for (int i = first; i < last; ++i) strain = std::max(strain, full_stretching(i).largest_strain);
    return strain;
  };
  double strain = 0;
  for (const double part :
       values_of_ranges<double>(loop(), static_cast<int>(model.elements.size()), kElementRange, largest)) {
    strain = std::max(strain, part);
  }
  const double ratio = 1 + 3 * strain;
  return stable_step_of_mode(straight.stiffness * ratio, straight.damping * ratio);
}

}  // namespace netpocket
