#pragma once

#include <vector>

#include "render/output/image.h"

namespace netpocket {

// Pictures of one height next to each other, from left to right. Transparent where they are, if any is.
Image side_by_side(const std::vector<Image>& images);

}  // namespace netpocket
