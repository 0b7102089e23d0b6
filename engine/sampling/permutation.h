#pragma once
// Random order of the numbers 0 to count - 1, computed for one place at a time. Pure function.

#include <cstdint>

namespace netpocket {

// The number at `place` (< count). Different seeds and axes give different orders. The method is a Feistel network of
// Philox rounds over the next even power of 2, applied again while its result is not below `count` ("cycle walking":
// Black & Rogaway 2002, Ciphers with arbitrary finite domains, doi:10.1007/3-540-45760-7_9). count <= 2^62.
std::uint64_t permuted(std::uint64_t place, std::uint64_t count, std::uint64_t seed, std::uint32_t axis);

}  // namespace netpocket
