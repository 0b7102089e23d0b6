#pragma once
// A moment of a run as VTK meshes, for files that ParaView reads.

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "engine/state/snapshot.h"
#include "engine/state/structure.h"
#include "render/scene/element_curve.h"

namespace netpocket {

// What a run is made of in such files. The numbers are those of a series' parts.
enum class RunPart : std::uint8_t { lines = 0, bodies = 1, ropes = 2 };

inline constexpr std::array kRunParts = {RunPart::lines, RunPart::bodies, RunPart::ropes};

// As files are called: "lines", "bodies" or "ropes".
std::string run_part_name(RunPart part);

// Lines always, the others where the run has them.
std::vector<RunPart> run_parts(const Structure& structure);

// Cords and rods, a line for each element: tension (N), strain (Green), group (index into Structure::element_groups,
// whose names are the field data "groups") and thread by line, velocity (m/s) by point. Positions in m, world frame.
vtkSmartPointer<vtkPolyData> line_mesh(const Structure& structure, const Snapshot& snapshot, const ElementCurve& curve);

// The ropes without elements (NodeLook::rope): parts of a drawstring through rings, a tether on a drum.
std::vector<NodeGroup> rope_groups(const Structure& structure);

// These ropes, each a line that runs straight from node to node, also where it is slack: its index in `rope` by line
// (into rope_groups(), whose names are the field data "ropes") and velocity (m/s) by point. Positions in m, world
// frame.
vtkSmartPointer<vtkPolyData> rope_mesh(const Structure& structure, const Snapshot& snapshot);

// The bodies' true surfaces at their poses: their index in `body` by polygon, outward `Normals` by point.
vtkSmartPointer<vtkPolyData> body_meshes(const Structure& structure, const Snapshot& snapshot);

// That of these which is the part; `curve` is for lines.
vtkSmartPointer<vtkPolyData> part_mesh(RunPart part, const Structure& structure, const Snapshot& snapshot,
                                       const ElementCurve& curve);

}  // namespace netpocket
