#pragma once
// Share of a target's surface that lies under the net. Pure function: any thread may call it.
//
// Definition: a point of the surface is under the net if some cord or rope lies within one mesh size of it, on the
// outer side of its tangent plane. A net that lies on the surface leaves no point farther than half a mesh from its
// cords (middle of a square mesh), so a smaller reach would count the middles of meshes as bare; and what is farther
// than a mesh from every cord can pass between them without touching. A net that hovers above the surface therefore
// counts as long as its height is below about 0.9 meshes (sqrt(1 - 1/4) over the middle of a mesh).

#include <vector>

#include "engine/analysis/metrics/net_geometry.h"
#include "engine/analysis/metrics/target_samples.h"
#include "engine/state/snapshot.h"

namespace netpocket {

// `samples` in the axes of `body`; `segments` in world axes; `reach`: mesh size, m. From 0 to 1; NaN without samples.
double covered_share(const std::vector<SurfaceSample>& samples, const BodyState& body,
                     const std::vector<CordSegment>& segments, double reach);

}  // namespace netpocket
