#pragma once
// The phases of captures as bands of figures.

#include <vector>

#include "render/figures/figure.h"
#include "render/figures/run_series.h"

namespace netpocket {

// Bands of a run's phases. Each ends where the next one begins or, at the latest, at the end of the run.
std::vector<PhaseBand> phase_bands(const RunSeries& run);
// The same for the phases that all runs have, at the same times, until the end of the longest run.
std::vector<PhaseBand> common_phases(const std::vector<RunSeries>& runs);

}  // namespace netpocket
