#pragma once
// How lines stand in depth. Atmospheric perspective: what is farther away fades towards the background, so that the
// front of a net can be told from its back.

#include <vtkActor.h>
#include <vtkCamera.h>

#include "render/scene/color.h"

namespace netpocket {

// Makes an actor fade towards `distance_color`; call set_depth_fading before each drawing. `nearer`: fraction of the
// depth range by which it is drawn in front of what is at the same place; 1: of everything; negative: behind it.
void add_depth_fading(vtkActor& actor, const Color& distance_color, double nearer);

// Nothing fades at the near clipping plane, `strength` (0 to 1) of the colour at the far one.
void set_depth_fading(vtkActor& actor, vtkCamera& camera, double strength);

}  // namespace netpocket
