#pragma once
// Instruction-set variants of the search for the fastest coordinate. Internal to MotionBound.

#include <cstddef>

#include "engine/math/instruction_set.h"

namespace netpocket::motion_kernel {

// Largest (weight |v|)^2 over `blocks` blocks of eight vectors (CoordinateRows), with one weight per vector; NaN if any
// value is NaN.
using Kernel = double (*)(const double* rows, const double* weights, std::size_t blocks);

NETPOCKET_VARIANTS(double largest_square(const double* rows, const double* weights, std::size_t blocks);)

}  // namespace netpocket::motion_kernel
