#pragma once
// Materials of cords and inflatable rods from their dimensions.

#include "engine/model/model.h"
#include "engine/scenario/scenario.h"

namespace netpocket {

// Solid round cord: A = pi d^2/4, I = pi d^4/64.
CableMaterial cord_material(const CordParameters& cord);

// Thin tube: A = pi (D^2 - d^2)/4, I = pi (D^4 - d^4)/64 with d = D - 2 wall.
CableMaterial rod_material(const RodParameters& rods, double wall);

}  // namespace netpocket
