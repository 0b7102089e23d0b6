#include "engine/scenario/mesh_unit.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace netpocket {

double metres(MeshUnit unit) {
  constexpr std::array kMetres = {1.0, 1e-2, 1e-3, 0.0254, 0.3048};
  return kMetres[static_cast<std::size_t>(unit)];
}

MeshUnit likely_unit(double extent) {
  constexpr double kSmallest = 0.5, kLargest = 15;  // m, of bodies that a pocket can catch
  constexpr std::array kOrder = {MeshUnit::metre, MeshUnit::millimetre, MeshUnit::centimetre, MeshUnit::inch,
                                 MeshUnit::foot};
  MeshUnit best = MeshUnit::metre;
  double best_miss = HUGE_VAL;
  for (const MeshUnit unit : kOrder) {
    const double size = extent * metres(unit);
    const double miss = std::max({1.0, kSmallest / size, size / kLargest});
    if (miss < best_miss) {
      best = unit;
      best_miss = miss;
    }
  }
  return best;
}

}  // namespace netpocket
