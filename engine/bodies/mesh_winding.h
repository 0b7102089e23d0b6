#pragma once
// Orientation of the triangles of a mesh. Any thread may call these functions.

#include "engine/bodies/mesh_data.h"

namespace netpocket {

struct WindingChange {
  std::size_t triangles = 0;     // number turned to face the same way as their neighbours
  std::size_t parts = 0;         // number of closed parts turned to face outwards
  std::size_t unorientable = 0;  // number of parts left unchanged: Moebius strips
};

// Makes the triangles of each part face the same way by turning the minority. Then turns closed parts that face inwards
// outwards. Hollows, which lie in another part and face the other way, stay hollows.
WindingChange wind_consistently(MeshData& mesh);

}  // namespace netpocket
