#pragma once
// SIMD types: several doubles that are computed at once, as many as one register of the instruction set holds. Each
// lane holds the value of one cable element or coordinate. Data comes in blocks of eight; a kernel processes a block in
// parts of kWidth lanes. Only additions, multiplications, divisions and square roots are used, each rounded separately
// (-ffp-contract=off). Therefore every instruction set gives the same bits.
//
// Only sources that are compiled once per instruction set may include this header. Everything here has internal
// linkage, so that code which runs on an older processor never uses a copy compiled for a newer one.

#include <immintrin.h>

#include <cstddef>
#include <cstdint>

#include "engine/math/block_size.h"

namespace netpocket::simd {
namespace {

constexpr int kBlock = kBlockSize;  // lanes of a block of data
#if defined(__AVX512F__)
constexpr int kWidth = 8;
#elif defined(__AVX__)
constexpr int kWidth = 4;
#else
constexpr int kWidth = 2;
#endif
constexpr int kParts = kBlock / kWidth;

using SimdDouble [[gnu::vector_size(kWidth * sizeof(double))]] = double;
using UnalignedSimdDouble [[gnu::vector_size(kWidth * sizeof(double)), gnu::aligned(sizeof(double))]] = double;

#define NETPOCKET_INLINE [[gnu::always_inline]] static inline

// Loads part `part` of the block of eight that starts at `block` (64-byte aligned).
NETPOCKET_INLINE SimdDouble load(const double* block, int part) {
  return *reinterpret_cast<const SimdDouble*>(block + part * kWidth);
}
NETPOCKET_INLINE void store(double* block, int part, const SimdDouble& value) {
  *reinterpret_cast<SimdDouble*>(block + part * kWidth) = value;
}
NETPOCKET_INLINE SimdDouble load_unaligned(const double* values) {
  return *reinterpret_cast<const UnalignedSimdDouble*>(values);
}
NETPOCKET_INLINE SimdDouble broadcast(double value) { return SimdDouble{} + value; }

NETPOCKET_INLINE SimdDouble larger(const SimdDouble& a, const SimdDouble& b) { return a < b ? b : a; }

// False where a lane is zero or not a number.
NETPOCKET_INLINE bool are_all_negative(const SimdDouble& value) {
  bool all = true;
  for (int i = 0; i < kWidth; ++i) all &= value[i] < 0;
  return all;
}

NETPOCKET_INLINE bool is_any_positive(const SimdDouble& value) {
#if defined(__AVX512F__)
  return _mm512_cmp_pd_mask(__m512d(value), _mm512_setzero_pd(), _CMP_GT_OQ) != 0;
#elif defined(__AVX__)
  return _mm256_movemask_pd(_mm256_cmp_pd(__m256d(value), _mm256_setzero_pd(), _CMP_GT_OQ)) != 0;
#else
  return _mm_movemask_pd(_mm_cmpgt_pd(__m128d(value), _mm_setzero_pd())) != 0;
#endif
}

// The lanes where a <= b, as bits.
NETPOCKET_INLINE unsigned lanes_at_most(const SimdDouble& a, const SimdDouble& b) {
#if defined(__AVX512F__)
  return _mm512_cmp_pd_mask(__m512d(a), __m512d(b), _CMP_LE_OQ);
#elif defined(__AVX__)
  return static_cast<unsigned>(_mm256_movemask_pd(_mm256_cmp_pd(__m256d(a), __m256d(b), _CMP_LE_OQ)));
#else
  return static_cast<unsigned>(_mm_movemask_pd(_mm_cmple_pd(__m128d(a), __m128d(b))));
#endif
}

NETPOCKET_INLINE SimdDouble square_root(const SimdDouble& value) {
#if defined(__AVX512F__)
  return SimdDouble(_mm512_maskz_sqrt_pd(0xff, __m512d(value)));  // without a mask GCC 12 warns
#elif defined(__AVX__)
  return SimdDouble(_mm256_sqrt_pd(__m256d(value)));
#else
  return SimdDouble(_mm_sqrt_pd(__m128d(value)));
#endif
}

// Loads part `part` of a block whose values are rotated: lane i of the eight receives block[(i + rotation) mod 8].
NETPOCKET_INLINE SimdDouble load_rotated(const double* block, int part, int rotation) {
  if (rotation == 0) return load(block, part);
#if defined(__AVX512F__)
  using Order [[gnu::vector_size(sizeof(SimdDouble))]] = std::int64_t;
  const Order order = (Order{0, 1, 2, 3, 4, 5, 6, 7} + rotation) & 7;
  return SimdDouble(
      _mm512_maskz_permutexvar_pd(0xff, __m512i(order), __m512d(load(block, part))));  // without a mask GCC warns
#else
  const int first = (part * kWidth + rotation) % kBlock;
  if (first + kWidth <= kBlock) return *reinterpret_cast<const UnalignedSimdDouble*>(block + first);
  SimdDouble value = {};
  for (int i = 0; i < kWidth; ++i) value[i] = block[(first + i) % kBlock];
  return value;
#endif
}

// With another value in one lane. Writing a lane by its index would pass through memory.
NETPOCKET_INLINE SimdDouble with_lane(const SimdDouble& all, int lane, double value) {
  using Lanes [[gnu::vector_size(sizeof(SimdDouble))]] = std::int64_t;
#if defined(__AVX512F__)
  constexpr Lanes kLanes = {0, 1, 2, 3, 4, 5, 6, 7};
#elif defined(__AVX__)
  constexpr Lanes kLanes = {0, 1, 2, 3};
#else
  constexpr Lanes kLanes = {0, 1};
#endif
  return kLanes == Lanes{} + lane ? broadcast(value) : all;
}

NETPOCKET_INLINE SimdDouble gather(const double* row, const std::ptrdiff_t* place) {
  SimdDouble value = {};
  for (int i = 0; i < kWidth; ++i) value[i] = row[place[i]];
  return value;
}

// A vector in space for each lane.
struct SimdVector {
  SimdDouble x, y, z;
};
NETPOCKET_INLINE SimdVector operator+(const SimdVector& a, const SimdVector& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
NETPOCKET_INLINE SimdVector operator-(const SimdVector& a, const SimdVector& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
NETPOCKET_INLINE SimdVector operator*(const SimdDouble& s, const SimdVector& a) { return {s * a.x, s * a.y, s * a.z}; }
// Gathers vectors from three consecutive rows of eight: x, y, z.
NETPOCKET_INLINE SimdVector gather3(const double* rows, const std::ptrdiff_t* place) {
  return {gather(rows, place), gather(rows + kBlock, place), gather(rows + 2 * kBlock, place)};
}
NETPOCKET_INLINE SimdVector cross(const SimdVector& a, const SimdVector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
// x and z are added first, so that the sum keeps its bits when the pocket is rotated by 90 degrees about its axis.
NETPOCKET_INLINE SimdDouble dot(const SimdVector& a, const SimdVector& b) {
  return (a.x * b.x + a.z * b.z) + a.y * b.y;
}

}  // namespace
}  // namespace netpocket::simd
