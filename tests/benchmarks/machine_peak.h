#pragma once
// What the processor can do at most without fused multiply-add, which the kernels may not use.

namespace netpocket {

// Additions and multiplications of doubles, as many of each, on `count` rounds of independent chains that stay in
// registers, by the widest instructions that the element kernel uses on this machine. Returns the number of operations.
double run_peak(int count);

}  // namespace netpocket
