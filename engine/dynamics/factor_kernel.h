#pragma once
// The instruction-set variants of a solve with a sparse factored matrix, x, y and z at once. Internal to
// ConsistentMass.

#include <cstdint>

namespace netpocket::factor_kernel {

// L D L^T, L unit lower triangular without its diagonal, by columns.
struct FactorView {
  std::int32_t columns;              // eliminated; rows below them are solved for between the two passes
  const std::int32_t* column_begin;  // columns + 1
  const std::int32_t* row;
  const double* value;
  const double* inverse_diagonal;
};

// One row of the right-hand side or solution: x, y, z and an unused number.
struct alignas(32) Row {
  double value[4];
};

// Forward pass: rows -= L (rows above). Backward pass: rows = D^-1 rows - L^T (rows below).
using Kernel = void (*)(const FactorView& factor, Row* rows);
struct Kernels {
  Kernel forward, backward;
};

namespace baseline {
void forward(const FactorView& factor, Row* rows);
void backward(const FactorView& factor, Row* rows);
}  // namespace baseline
namespace avx2 {
void forward(const FactorView& factor, Row* rows);
void backward(const FactorView& factor, Row* rows);
}  // namespace avx2
namespace avx512 {
void forward(const FactorView& factor, Row* rows);
void backward(const FactorView& factor, Row* rows);
}  // namespace avx512

}  // namespace netpocket::factor_kernel
