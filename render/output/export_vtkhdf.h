#pragma once
// A recorded run for ParaView in files with time steps: lines.vtkhdf (cords and rods), bodies.vtkhdf and, where a rope
// has no elements (a drawstring through rings, a tether on a drum), ropes.vtkhdf.
// Errors: RenderError or FileError with one sentence. Whatever happens, only whole files are left.

#include <stop_token>
#include <string>
#include <vector>

#include "engine/recording/recording.h"
#include "render/output/render_progress.h"

namespace netpocket {

// The files that export_vtkhdf() writes.
std::vector<std::string> vtkhdf_files(const Recording& recording, const std::string& folder);

// The meshes are those of run_meshes.h, a straight line for each element. Names of groups, threads, bodies and
// ropes are in the tables /netpocket/groups, /netpocket/threads, /netpocket/bodies and /netpocket/ropes. When stopped,
// nothing is written.
RenderOutcome export_vtkhdf(const Recording& recording, const std::string& folder,
                            const RenderProgressCallback& progress = {}, const std::stop_token& stop = {});

}  // namespace netpocket
