#pragma once
// Eight doubles that are computed at once: one value for each of eight cable elements or coordinates. The compiler maps
// them to one AVX-512, two AVX2 or four SSE2 registers. Only additions, multiplications and divisions are used, each
// rounded on its own (-ffp-contract=off), so that every instruction set gives the same bits.
//
// To be included only by sources that are compiled once per instruction set; everything here has internal linkage so
// that no copy compiled for a newer processor can end up in code that an older one runs.

#include <cstdint>

namespace netpocket::lanes {
namespace {

constexpr int kLanes = 8;
using Lanes [[gnu::vector_size(64)]] = double;
using LaneMask [[gnu::vector_size(64)]] = std::int64_t;

#define NETPOCKET_INLINE [[gnu::always_inline]] static inline

NETPOCKET_INLINE Lanes load(const double* aligned) { return *reinterpret_cast<const Lanes*>(aligned); }
NETPOCKET_INLINE void store(double* aligned, const Lanes& value) { *reinterpret_cast<Lanes*>(aligned) = value; }
NETPOCKET_INLINE Lanes broadcast(double value) { return Lanes{} + value; }

// Lane i receives value[(i + rotation) mod 8].
NETPOCKET_INLINE Lanes rotated(const Lanes& value, int rotation) {
  switch (rotation) {
    case 1:
      return __builtin_shufflevector(value, value, 1, 2, 3, 4, 5, 6, 7, 0);
    case 2:
      return __builtin_shufflevector(value, value, 2, 3, 4, 5, 6, 7, 0, 1);
    case 3:
      return __builtin_shufflevector(value, value, 3, 4, 5, 6, 7, 0, 1, 2);
    case 4:
      return __builtin_shufflevector(value, value, 4, 5, 6, 7, 0, 1, 2, 3);
    case 5:
      return __builtin_shufflevector(value, value, 5, 6, 7, 0, 1, 2, 3, 4);
    case 6:
      return __builtin_shufflevector(value, value, 6, 7, 0, 1, 2, 3, 4, 5);
    case 7:
      return __builtin_shufflevector(value, value, 7, 0, 1, 2, 3, 4, 5, 6);
    default:
      return value;
  }
}

NETPOCKET_INLINE Lanes gather(const double* base, const std::int32_t* index) {
  Lanes value;
  for (int i = 0; i < kLanes; ++i) value[i] = base[index[i]];
  return value;
}

// A vector in space for each lane.
struct Lanes3 {
  Lanes x, y, z;
};
NETPOCKET_INLINE Lanes3 operator+(const Lanes3& a, const Lanes3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
NETPOCKET_INLINE Lanes3 operator-(const Lanes3& a, const Lanes3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
NETPOCKET_INLINE Lanes3 operator*(const Lanes& s, const Lanes3& a) { return {s * a.x, s * a.y, s * a.z}; }
// x and z first: the sum keeps its bits when the pocket is turned by 90 degrees about its axis.
NETPOCKET_INLINE Lanes dot(const Lanes3& a, const Lanes3& b) { return (a.x * b.x + a.z * b.z) + a.y * b.y; }

}  // namespace
}  // namespace netpocket::lanes
