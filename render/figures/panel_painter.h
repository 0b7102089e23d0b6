#pragma once

#include <cairo.h>

#include <string>

#include "render/figures/figure.h"
#include "render/figures/panel_layout.h"

namespace netpocket {

// Draws one panel into its frame. `letter` is put before the title, e.g. "(a)"; may be empty.
void paint_panel(cairo_t* context, const Panel& panel, const PanelLayout& layout, const std::string& letter);

}  // namespace netpocket
