#pragma once
// The unit of a mesh file's coordinates, which the file does not name.

#include "engine/scenario/scenario.h"

namespace netpocket {

double metres(MeshUnit unit);

// The unit in which a body of this extent (coordinates as they are) is most likely written: the one in which it fits a
// pocket, metres and millimetres first; else the one in which it comes nearest to that.
MeshUnit likely_unit(double extent);

}  // namespace netpocket
