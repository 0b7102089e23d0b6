#pragma once
// Instruction-set variants of the innermost loop of near_pairs.

#include <cstdint>

#include "engine/math/instruction_set.h"

namespace netpocket::sweep_kernel {

// Entries in the order of `place`. Each row has kPadding entries more, which may hold anything.
struct Rows {
  const double* place;
  const double *low[3], *high[3];  // of the entries' boxes, m; `high` includes the margin
};
constexpr std::int32_t kPadding = 8;

// Writes the entries behind `entry` whose place is at most `last_place` and whose boxes meet its box along every axis
// to `found`, in ascending order. Returns their number. `end`: number of entries. `found` must have room for
// end - entry.
using MeetingKernel = std::int32_t (*)(const Rows& rows, std::int32_t entry, std::int32_t end, double last_place,
                                       std::int32_t* found);

NETPOCKET_VARIANTS(std::int32_t meeting(const Rows&, std::int32_t, std::int32_t, double, std::int32_t*);)

}  // namespace netpocket::sweep_kernel
