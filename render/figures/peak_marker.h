#pragma once
// A mark where a curve over time is farthest from zero, with its value and time in the legend.

#include <optional>
#include <vector>

#include "render/figures/figure.h"

namespace netpocket {

// `times` in s. Values that are not finite or closer to zero than `least` do not count; nothing when none is left.
std::optional<Curve> peak_marker(const std::vector<double>& times, const std::vector<double>& values,
                                 const std::string& unit, double least);

}  // namespace netpocket
