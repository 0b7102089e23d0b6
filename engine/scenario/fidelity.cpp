#include "engine/scenario/fidelity.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/scenario/draft_bias.h"

namespace netpocket {

MeshDivision mesh_division(const Scenario& scenario) {
  const PocketParameters& pocket = scenario.pocket;
  if (scenario.solver.fidelity == Fidelity::draft) {
    return {std::min(pocket.mesh_columns, kDraftMeshes), std::min(pocket.mesh_rows, kDraftMeshes), 1, 1};
  }
  const int of_rods = scenario.rods.elements_per_side;
  return {pocket.mesh_columns, pocket.mesh_rows, pocket.elements_per_side,
          of_rods > 0 ? of_rods : pocket.elements_per_side};
}

double axial_softening(const Scenario& scenario) {
  return scenario.solver.fidelity == Fidelity::draft ? kDraftSoftening : 1;
}

std::string draft_notice(Fidelity fidelity) {
  if (fidelity == Fidelity::full) return "";
  const DraftBias& b = kDraftBias;
  return fmt::format(
      "coarse mesh, axial stiffness divided by {:g}; bias over {} scattered captures, 95 %: probability of capture "
      "{:+.1f} +- {:.1f} percentage points, first contact {:+.3f} +- {:.3f} s, impulse on the target {:+.1f} +- "
      "{:.1f} %",
      kDraftSoftening, b.captures, 100 * b.probability.mean, 100 * b.probability.half_width, b.first_contact.mean,
      b.first_contact.half_width, 100 * b.impulse.mean, 100 * b.impulse.half_width);
}

}  // namespace netpocket
