#pragma once
// The Halton sequence: coordinate i of a point is the point's index with its digits in the i-th prime mirrored at the
// radix point. Halton (1960), Numer. Math. 2, doi:10.1007/BF01386213. Pure functions: any thread may call them.

#include <cstdint>

namespace netpocket {

// Mirrors the digits of `index` in base `base` at the radix point. The result is in [0, 1).
double radical_inverse(std::uint64_t index, std::uint64_t base);

// The i-th prime number: 2, 3, 5, ... for i = 0, 1, 2, ... up to kMostDimensions - 1 of design.h.
std::uint64_t prime(int i);

// (number + shift) modulo 1.
double shifted(double number, double shift);

// Coordinate `axis` of point `index`, moved by a random shift modulo 1 (Cranley & Patterson 1976, SIAM J. Numer. Anal.
// 13(6), doi:10.1137/0713071), so that different seeds give different samples that are equally even. In [0, 1).
double shifted_halton(std::uint64_t index, int axis, std::uint64_t seed);

}  // namespace netpocket
