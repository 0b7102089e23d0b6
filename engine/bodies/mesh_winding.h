#pragma once
// Which way the triangles of a mesh face. Any thread may call these functions.

#include "engine/bodies/mesh_data.h"

namespace netpocket {

struct WindingChange {
  std::size_t triangles = 0;     // turned to face as the neighbours in their part
  std::size_t parts = 0;         // closed ones turned to face outwards
  std::size_t unorientable = 0;  // parts left as they are: Moebius strips
};

// Lets the triangles of each part face the same way, turning the fewer, and closed parts that faced inwards outwards;
// hollows, which lie in another part and faced the other way, stay hollows.
WindingChange wind_consistently(MeshData& mesh);

}  // namespace netpocket
