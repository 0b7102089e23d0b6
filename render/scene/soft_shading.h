#pragma once
// The light on solid things: a large soft lamp above the viewer's left shoulder, light from all around in the shade, a
// mild gloss. One expression a pixel instead of VTK's sum over lamps, which in software takes three times as long.

#include <vtkActor.h>

#include "render/scene/scene_options.h"

namespace netpocket {

// The actor's mesh needs normals. In space the shade is darker: there is no sky.
void add_soft_shading(vtkActor& actor, Background background);

}  // namespace netpocket
