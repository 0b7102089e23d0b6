#pragma once
// A run as the engine would record it, made from formulas: closing from 5.78 m to 2.1 m, three contact episodes of
// tens of newtons with spikes, towing from 10 s, lateral motions of 1e-3 m (target) and 1e-5 m (spacecraft).

#include <string>

#include "render/figures/run_series.h"

namespace netpocket {

RunSeries synthetic_run(const std::string& name, double closing_time);

}  // namespace netpocket
