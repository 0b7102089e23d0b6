#pragma once
// Three numbers that happen to be equal, by what they count.

namespace netpocket {

// Values that the widest register holds (AVX-512). Kernels for lesser instruction sets go through them in parts.
inline constexpr int kLanes = 8;
// Elements or coordinates that lie together in memory and are computed at once: whole registers.
inline constexpr int kBlockSize = 8;
// Sectors of a symmetric pocket. With the sector's index running fastest, a block holds one item of each sector.
inline constexpr int kSectors = 8;

static_assert(kBlockSize % kLanes == 0);

}  // namespace netpocket
