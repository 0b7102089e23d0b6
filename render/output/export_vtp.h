#pragma once
// A recorded run for ParaView: netpocket.pvd and, for each frame, lines_0000.vtp (cords and rods), bodies_0000.vtp and,
// where a rope has no elements (a drawstring through rings, a tether on a drum), ropes_0000.vtp.
// Errors: RenderError or FileError with one sentence. Whatever happens, only whole files are left.

#include <stop_token>
#include <string>

#include "engine/recording/recording.h"
#include "render/output/render_progress.h"

namespace netpocket {

struct VtpOptions {
  int segments = 1;  // straight pieces of an element; more follow its cubic curve
};

// The name of a frame's file; `part` is "lines", "bodies" or "ropes".
std::string vtp_file_name(const std::string& part, std::size_t frame);

// Lines carry tension (N), strain (Green), group (index into Structure::element_groups, whose names are the field data
// "groups") and thread by element and velocity (m/s) by point; bodies carry their index in `body` by polygon and
// outward `Normals` by point; ropes, a line for each, carry their index in `rope` (names: "ropes") and velocity.
// Positions in m, world frame.
RenderOutcome export_vtp(const Recording& recording, const std::string& folder, const VtpOptions& options = {},
                         const RenderProgressCallback& progress = {}, const std::stop_token& stop = {});

}  // namespace netpocket
