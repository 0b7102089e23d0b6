#pragma once
// The Sobol sequence with the direction numbers of Joe & Kuo (2008), SIAM J. Sci. Comput. 30(5), doi:10.1137/070709359,
// from Boost.Random, in the order of the Gray code (Antonov & Saleev 1979, USSR Comput. Maths. Math. Phys. 19(1)). Pure
// functions: any thread may call them.

#include <array>
#include <cstdint>

#include "engine/sampling/design.h"

namespace netpocket {

// Coordinate `axis` (0 to kMostDimensions - 1 of design.h) of point `index` (0, 1, ... below 2^32), in [0, 1). Point 0
// is the origin.
double sobol(std::uint64_t index, int axis);

// The points one after the other, from point 0, in some coordinates: the numbers of sobol(), for much less work.
class SobolWalk {
 public:
  explicit SobolWalk(int dimensions) : dimensions_(dimensions) {}  // at most kMostDimensions

  void next();
  double operator[](int axis) const;

 private:
  int dimensions_;
  std::uint64_t index_ = 0;
  std::array<std::uint32_t, kMostDimensions> bits_{};  // by axis
};

// The same with Owen's nested uniform scrambling: each digit is flipped or not depending on all digits before it, by a
// hash of the seed. Points of the same count remain as even, and different seeds give independent scramblings. Owen
// (1995), doi:10.1007/978-1-4612-2552-2_19; hash: Laine & Karras (2011), doi:10.1111/j.1467-8659.2011.02010.x, in the
// form of Burley (2020), Practical hash-based Owen scrambling, J. Comput. Graph. Techn. 9(4).
double scrambled_sobol(std::uint64_t index, int axis, std::uint64_t seed);

}  // namespace netpocket
