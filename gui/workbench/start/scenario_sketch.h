#pragma once
// A small picture of how a scenario begins. It is drawn without OpenGL, so that it can be drawn on any thread beside
// the views: VTK binds its OpenGL functions once per process.

#include <QImage>

#include "gui/workbench/simulation/pocket_preview.h"
#include "render/scene/scene_options.h"

namespace netpocket {

// `pixels`: size of the picture. Any thread may call it.
QImage sketch_pocket(const PocketPreview& pocket, const QSize& pixels, Background background);

}  // namespace netpocket
