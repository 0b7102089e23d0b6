#pragma once
// The control loops of a run as their structure describes them (state/control_loop_info.h).

#include <set>
#include <string>
#include <vector>

#include "render/figures/figure.h"
#include "render/figures/run_series.h"

namespace netpocket {

bool has_control_loops(const RunSeries& run);

// Channels that the figure below shows, or of which it shows what matters.
std::set<std::string> loop_channels(const RunSeries& run);

// One row for each loop of the first run: what it controls, and its force or torque. Scalars are drawn with their set
// point, vectors as the components of their error. Several runs over each other: sizes, with a curve for each run.
// Loops with the same table, such as winches, share a row. Disturbances that act follow.
Figure control_loops_figure(const std::vector<RunSeries>& runs);
// The same for the row of one loop, by its name; of all when there is none of that name.
Figure control_loop_figure(const std::vector<RunSeries>& runs, const std::string& loop);

}  // namespace netpocket
