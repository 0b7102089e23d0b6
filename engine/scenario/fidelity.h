#pragma once
// What `solver.fidelity = "draft"` means: a coarser and softer pocket for maps of many captures (THEORY.md 7.4).
//
// - The net has at most three meshes across a panel, three rows of squares and one element a side (kDraftMeshes).
// - The axial stiffness of cords, closing ropes and rods is divided by kDraftSoftening. So their axial waves, which
//   limit the step of a coarse pocket, allow one 5.5 times as long; bending is not softened. Under a given tension
//   axial strains are that much larger, tensions are not. The tether of a pocket that is put down stays as it is.
//
// Its bias against the mesh as given is measured (draft_bias.h) and stated with each draft result.

#include <string>

#include "engine/scenario/scenario.h"

namespace netpocket {

inline constexpr int kDraftMeshes = 3;
inline constexpr double kDraftSoftening = 30;

// How the cords of a pocket are divided in a run of this scenario.
struct MeshDivision {
  int columns, rows;      // meshes across a panel at the kink, and rows of squares above it
  int per_side;           // elements on a side of a mesh
  int per_side_of_a_rod;  // elements of a rod between two rows of the net
};
MeshDivision mesh_division(const Scenario& scenario);

// Divisor of the axial stiffness of cords, ropes and rods.
double axial_softening(const Scenario& scenario);

// A sentence for results of a draft: that they are one, and its measured bias. Empty for full fidelity.
std::string draft_notice(Fidelity fidelity);

}  // namespace netpocket
