// Compiled once per instruction set; NETPOCKET_ISA_NAME is the variant's namespace.

#include "engine/dynamics/assembly/motion_kernel.h"

#include "engine/ancf/element_batch.h"
#include "engine/math/simd.h"

namespace netpocket::motion_kernel::NETPOCKET_ISA_NAME {

using namespace simd;

// A maximum may miss a NaN, a sum does not.
double largest_square(const double* rows, const double* weights, std::size_t blocks) {
  SimdDouble largest[kParts] = {}, sum[kParts] = {};
  for (std::size_t block = 0; block < blocks; ++block) {
    for (int part = 0; part < kParts; ++part) {
      const SimdDouble x = load(rows, part), y = load(rows + kBlock, part), z = load(rows + 2 * kBlock, part);
      const SimdDouble weight = load(weights, part);
      const SimdDouble square = (weight * weight) * ((x * x + z * z) + y * y);
      largest[part] = larger(largest[part], square);
      sum[part] = sum[part] + square;
    }
    rows += kVectorRows * kBlock;
    weights += kBlock;
  }
  double result = 0, total = 0;
  for (int lane = 0; lane < kBlock; ++lane) {
    const double here = largest[lane / kWidth][lane % kWidth];
    result = here > result ? here : result;
    total += sum[lane / kWidth][lane % kWidth];
  }
  return total != total ? total : result;
}

}  // namespace netpocket::motion_kernel::NETPOCKET_ISA_NAME
