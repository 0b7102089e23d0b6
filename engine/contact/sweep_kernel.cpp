// Compiled once per instruction set; NETPOCKET_ISA_NAME is the variant's namespace.

#include "engine/contact/sweep_kernel.h"

#include "engine/math/simd.h"

namespace netpocket::sweep_kernel::NETPOCKET_ISA_NAME {

using namespace simd;

static_assert(kPadding >= kWidth);

std::int32_t meeting(const Rows& rows, std::int32_t entry, std::int32_t end, double last_place, std::int32_t* found) {
  const SimdDouble last = broadcast(last_place);
  SimdDouble low[3], high[3];
  for (int axis = 0; axis < 3; ++axis) {
    low[axis] = broadcast(rows.low[axis][entry]);
    high[axis] = broadcast(rows.high[axis][entry]);
  }
  std::int32_t* next = found;
  for (std::int32_t first = entry + 1; first < end; first += kWidth) {
    unsigned lanes = lanes_at_most(load_unaligned(rows.place + first), last);
    if (end - first < kWidth) lanes &= (1u << (end - first)) - 1;
    if (lanes == 0) break;
    for (int axis = 0; axis < 3; ++axis) {
      lanes &= lanes_at_most(load_unaligned(rows.low[axis] + first), high[axis]);
      lanes &= lanes_at_most(low[axis], load_unaligned(rows.high[axis] + first));
    }
    for (; lanes != 0; lanes &= lanes - 1) *next++ = first + __builtin_ctz(lanes);
  }
  return static_cast<std::int32_t>(next - found);
}

}  // namespace netpocket::sweep_kernel::NETPOCKET_ISA_NAME
