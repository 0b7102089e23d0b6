#pragma once

#include <cairo.h>

#include <string>

namespace netpocket {

// Draws with the font in a file from now on, the same on every machine: greys at the edges of letters, whatever
// Fontconfig is set to. Hinted letters keep to whole pixels; others have the same measures in every output.
void use_cairo_font(cairo_t* context, const std::string& file, double size, bool hinted);

}  // namespace netpocket
