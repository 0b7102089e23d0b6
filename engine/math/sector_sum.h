#pragma once
// Sums of contributions from the eight sectors of a pocket whose rounding does not break the pocket's symmetry. Each
// sector sums its own contributions in order. The total adds opposite sectors first,
// ((0+4) + (2+6)) + ((1+5) + (3+7)), so that equal and opposite contributions cancel exactly.

#include <array>

#include "engine/math/block_size.h"

namespace netpocket {

template <typename T>
class SectorSum {
 public:
  explicit SectorSum(const T& zero) { parts_.fill(zero); }

  // Adds a contribution of sector index % kSectors.
  void add(int index, const T& value) { parts_[index % kSectors] += value; }
  T total() const {
    static_assert(kSectors == 8);
    const T even = (parts_[0] + parts_[4]) + (parts_[2] + parts_[6]);
    const T odd = (parts_[1] + parts_[5]) + (parts_[3] + parts_[7]);
    return even + odd;
  }

 private:
  std::array<T, kSectors> parts_;
};

}  // namespace netpocket
