// Compiled once per instruction set, NETPOCKET_ISA_NAME being the variant's namespace.

#include "engine/dynamics/factor_kernel.h"

namespace netpocket::factor_kernel::NETPOCKET_ISA_NAME {
namespace {

using Four [[gnu::vector_size(4 * sizeof(double)), gnu::may_alias]] = double;

[[gnu::always_inline]] inline Four scaled(double factor, const Four& row) { return (Four{} + factor) * row; }

}  // namespace

void forward(const FactorView& factor, Row* rows) {
  Four* x = reinterpret_cast<Four*>(rows);
  for (std::int32_t j = 0; j < factor.columns; ++j) {
    const Four now = x[j];
    for (std::int32_t p = factor.column_begin[j]; p < factor.column_begin[j + 1]; ++p) {
      x[factor.row[p]] -= scaled(factor.value[p], now);
    }
  }
}

void backward(const FactorView& factor, Row* rows) {
  Four* x = reinterpret_cast<Four*>(rows);
  for (std::int32_t j = factor.columns - 1; j >= 0; --j) {
    // Two sums: each addition would wait for the one before.
    Four even = scaled(factor.inverse_diagonal[j], x[j]), odd{};
    std::int32_t p = factor.column_begin[j];
    const std::int32_t end = factor.column_begin[j + 1];
    for (; p + 1 < end; p += 2) {
      even -= scaled(factor.value[p], x[factor.row[p]]);
      odd -= scaled(factor.value[p + 1], x[factor.row[p + 1]]);
    }
    if (p < end) even -= scaled(factor.value[p], x[factor.row[p]]);
    x[j] = even + odd;
  }
}

}  // namespace netpocket::factor_kernel::NETPOCKET_ISA_NAME
