#pragma once

#include <string>
#include <vector>

#include "render/figures/run_series.h"

namespace netpocket {

// What the figures need of the recordings that the user names. Throws CommandError(bad_input).
std::vector<RunSeries> run_series_of(const std::vector<std::string>& paths);

}  // namespace netpocket
