#pragma once
// Figures in the language of the window. Those that are exported stay English, as the paper.

#include "render/figures/figure.h"

namespace netpocket {

Figure in_window_language(Figure figure);

}  // namespace netpocket
