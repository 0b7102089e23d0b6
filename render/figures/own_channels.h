#pragma once
// The channels that only one kind of capture system has. This program does not know them; their recording says what
// they are.

#include <vector>

#include "render/figures/figure.h"
#include "render/figures/run_series.h"

namespace netpocket {

bool has_own_channels(const RunSeries& run);

// One panel for each such channel of the first run, with a curve for every run that has it. Components of one quantity
// (same meaning and unit, names that differ after the last underscore) share a panel.
Figure own_channels_figure(const std::vector<RunSeries>& runs);

}  // namespace netpocket
