// Compiled once per instruction set; NETPOCKET_ISA_NAME is the variant's namespace.

#include "engine/dynamics/assembly/factor_kernel.h"

namespace netpocket::factor_kernel::NETPOCKET_ISA_NAME {
namespace {

using Four [[gnu::vector_size(4 * sizeof(double)), gnu::may_alias]] = double;

// value - (row of the triangle) x. Two partial sums shorten the chain of dependent additions.
[[gnu::always_inline]] inline Four less_row(const TriangleView& triangle, std::int32_t row, const Four* x,
                                            const Four& value) {
  Four even = value, odd{};
  std::int32_t p = triangle.begin[row];
  const std::int32_t end = triangle.begin[row + 1];
  for (; p + 1 < end; p += 2) {
    even -= (Four{} + triangle.value[p]) * x[triangle.column[p]];
    odd -= (Four{} + triangle.value[p + 1]) * x[triangle.column[p + 1]];
  }
  if (p < end) even -= (Four{} + triangle.value[p]) * x[triangle.column[p]];
  return even + odd;
}

}  // namespace

void forward(const TriangleView& lower, Row* rows) {
  Four* x = reinterpret_cast<Four*>(rows);
  for (std::int32_t i = 0; i < lower.rows; ++i) x[i] = less_row(lower, i, x, x[i]);
}

void backward(const TriangleView& upper, const double* scale, Row* rows) {
  Four* x = reinterpret_cast<Four*>(rows);
  for (std::int32_t i = upper.rows - 1; i >= 0; --i) x[i] = less_row(upper, i, x, (Four{} + scale[i]) * x[i]);
}

}  // namespace netpocket::factor_kernel::NETPOCKET_ISA_NAME
