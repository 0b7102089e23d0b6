#pragma once
// PNG pictures. A file appears under its name only when it is whole.

#include <string>

#include "render/output/image.h"

namespace netpocket {

// Replaces an existing file. Throws RenderError with one sentence that names the file.
void write_png(const Image& image, const std::string& path);

// Reads any PNG as RGB. Throws RenderError with one sentence that names the file.
Image read_png(const std::string& path);

}  // namespace netpocket
