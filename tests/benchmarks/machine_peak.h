#pragma once
// What the machine can do at most: operations without fused multiply-add, which the kernels may not use, and reading.

#include <span>

namespace netpocket {

// Additions and multiplications of doubles, as many of each, on `count` rounds of independent chains that stay in
// registers, by the widest instructions that the element kernel uses on this machine. Returns the number of operations.
double run_peak(int count);

// The sum of all: reads them in their order as fast as memory gives them.
double read_all(std::span<const double> values);

}  // namespace netpocket
