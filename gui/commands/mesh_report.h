#pragma once
// What a mesh is and what is wrong with it, as text.

#include <string>
#include <vector>

#include "engine/bodies/mesh_review.h"
#include "engine/scenario/scenario.h"

namespace netpocket {

// Extents, parts, volume and inertia, each on lines of their own; lengths in metres.
std::string mesh_report(const MeshReview& review);

// "unit  mm, as is likely: 3.2 m large; as m it would be 3200 m"; `extent` as written in the file.
std::string unit_line(MeshUnit unit, bool chosen, double extent);

// All faults with their first places; or that there are none.
std::string fault_lines(const MeshReview& review);

// "m", "mm", ...: as target.mesh_unit names it.
std::string unit_name(MeshUnit unit);
std::vector<std::string> unit_names();

// "label          value\n", as the report's lines are.
std::string report_line(const std::string& label, const std::string& value);

}  // namespace netpocket
