#pragma once
// A picture of triangles as they come, with what is wrong with them.
// Thread contract: the host's thread.

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "engine/bodies/mesh_data.h"
#include "render/gl/gl_host.h"
#include "render/output/image.h"

namespace netpocket {

struct MeshPicture {
  MeshData mesh;                                                             // m
  std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>> open_edges = {};  // m; lines that shine through
  std::vector<Eigen::Vector3d> faults = {};                                  // m; dots that shine through
  std::vector<std::string> lines = {};  // of text, in the upper left corner, the first in bold
  int width = 1280;                     // pixels
  int height = 720;                     // pixels
};

// Sides that triangles turn away from what they face are drawn in another colour: it shows where one looks into the
// body, or a triangle faces the wrong way. Throws RenderError.
Image draw_mesh(std::shared_ptr<GlHost> host, const MeshPicture& picture);

}  // namespace netpocket
