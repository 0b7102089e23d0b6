#pragma once
// Units of the coordinates in a mesh file. The file does not name its unit.

#include "engine/scenario/scenario.h"

namespace netpocket {

// Length of one unit, m.
double metres(MeshUnit unit);

// Most likely unit of a body of this extent (in units of the file). It is the first in which the body fits a pocket;
// metres and millimetres are tried first. If there is none, it is the unit that comes nearest to that.
MeshUnit likely_unit(double extent);

}  // namespace netpocket
