#pragma once
// Instruction-set variants of the solution with a sparse factored matrix, for x, y and z at once. Internal to
// ConsistentMass.

#include <cstdint>

#include "engine/math/instruction_set.h"

namespace netpocket::factor_kernel {

// A strictly triangular matrix, stored by rows.
struct TriangleView {
  std::int32_t rows;
  const std::int32_t* begin;   // index of each row's first entry; rows + 1 values
  const std::int32_t* column;  // by entry
  const double* value;
};

// One row of the right-hand side or solution: x, y, z and an unused number.
struct alignas(32) Row {
  double value[4];
};

// x -= lower x, from the first row to the last: solves (1 + lower) x = right.
using ForwardKernel = void (*)(const TriangleView& lower, Row* x);
// x = scale x - upper x, from the last row to the first: solves (1 + upper) x = scale right.
using BackwardKernel = void (*)(const TriangleView& upper, const double* scale, Row* x);
struct Kernels {
  ForwardKernel forward;
  BackwardKernel backward;
};

NETPOCKET_VARIANTS(void forward(const TriangleView& lower, Row* x);
                   void backward(const TriangleView& upper, const double* scale, Row* x);)

}  // namespace netpocket::factor_kernel
