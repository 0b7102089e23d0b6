#include "engine/math/elementary.h"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace netpocket {
namespace {

constexpr double kPi = 0x1.921fb54442d18p+1, kPiRest = 0x1.1a62633145c07p-53;
// Parts of pi/2. The first two have 33 bits, so that their products with integers up to 2^20 are exact (Cody & Waite
// 1980).
constexpr double kQuarter1 = 0x1.921fb544p+0, kQuarter2 = 0x1.0b4611a6p-34, kQuarter3 = 0x1.3198a2e037073p-69;
constexpr double kLargestAngle = 1e5;

// The unevaluated sum of a number and a small remainder.
struct Pair {
  double high, low;
};

// The sum and its rounding error, for |a| >= |b|.
Pair quick_sum(double a, double b) {
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

// An angle minus `quarters` right angles; `rest` is within pi/4 of zero.
struct Reduced {
  Pair rest;
  std::int64_t quarters;
};

Reduced reduce(double angle) {
  if (std::abs(angle) <= kPi / 4) return {{angle, 0}, 0};
  if (!(std::abs(angle) <= kLargestAngle)) angle = std::fmod(angle, kPi * 2);
  const double quarters = std::floor(angle / (kPi / 2) + 0.5);
  const double first = angle - quarters * kQuarter1;  // exact
  const double second = quarters * kQuarter2;
  const double high = first - second;
  const double high_error = (first - high) - second;
  const Pair rest = quick_sum(high, high_error - quarters * kQuarter3);
  return {rest, static_cast<std::int64_t>(quarters)};
}

// sum c[i] z^i
template <std::size_t N>
double polynomial(const std::array<double, N>& c, double z) {
  double sum = c[N - 1];
  for (std::size_t i = N - 1; i-- > 0;) sum = sum * z + c[i];
  return sum;
}

// (-1)^i/(2 i + 3)! for kFirst = 3 and (-1)^i/(2 i + 4)! for kFirst = 4: coefficients of the Taylor series of sine and
// cosine. Within pi/4 the omitted terms are below 1e-19.
template <int kFirst>
constexpr std::array<double, 8> alternating_inverse_factorials() {
  std::array<double, 8> list{};
  double factorial = 1;
  for (int i = 2; i < kFirst; ++i) factorial *= i;
  for (int i = 0; i < 8; ++i) {
    factorial *= i == 0 ? kFirst : (kFirst + 2 * i - 1.0) * (kFirst + 2 * i);
    list[i] = (i % 2 == 0 ? 1 : -1) / factorial;
  }
  return list;
}

double sine_near_zero(const Pair& x) {
  static constexpr auto kSeries = alternating_inverse_factorials<3>();
  const double z = x.high * x.high;
  return x.high + (x.low * (1 - 0.5 * z) - x.high * z * polynomial(kSeries, z));
}

double cosine_near_zero(const Pair& x) {
  static constexpr auto kSeries = alternating_inverse_factorials<4>();
  const double z = x.high * x.high, half = 0.5 * z;
  const double one_less = 1 - half;
  return one_less + (((1 - one_less) - half) + (z * z * polynomial(kSeries, z) - x.high * x.low));
}

// sin(rest + quarters pi/2).
double sine_of(const Reduced& angle, std::int64_t quarters) {
  const bool odd = (quarters & 1) != 0, negative = (quarters & 2) != 0;
  const double value = odd ? cosine_near_zero(angle.rest) : sine_near_zero(angle.rest);
  return negative ? -value : value;
}

// atan(i/4).
constexpr std::array<Pair, 5> kArcs = {{{0, 0},
                                        {0x1.f5b75f92c80ddp-3, 0x1.8ab6e3cf7afbdp-57},
                                        {0x1.dac670561bb4fp-2, 0x1.a2b7f222f65e2p-56},
                                        {0x1.4978fa3269ee1p-1, 0x1.2419a87f2a458p-56},
                                        {kPi / 4, kPiRest / 4}}};

// base + sign atan(y/x) for 0 <= y <= x > 0, where base is 0 or at least pi/2. If the ratio is at least 3/16, it is
// reduced by the nearest c = i/4:
//   atan(y/x) = atan(c) + atan((y - c x)/(x + c y)).
// The truncation error of the series for the remainder is below 1e-18 of it.
double arc_from(const Pair& base, double sign, double y, double x) {
  static constexpr std::array<double, 11> kSeries = {-1.0 / 3,  1.0 / 5,  -1.0 / 7,  1.0 / 9,  -1.0 / 11, 1.0 / 13,
                                                     -1.0 / 15, 1.0 / 17, -1.0 / 19, 1.0 / 21, -1.0 / 23};
  const double ratio = y / x;
  const std::size_t place = ratio < 0.1875 ? 0 : static_cast<std::size_t>(4 * ratio + 0.5);
  const double c = 0.25 * static_cast<double>(place);
  const double rest = sign * (place == 0 ? ratio : (y - c * x) / (x + c * y));
  const double z = rest * rest;
  const double bend = rest * z * polynomial(kSeries, z);
  if (base.high == 0 && place == 0) return rest + bend;
  const Pair arc = {sign * kArcs[place].high, sign * kArcs[place].low};
  const Pair whole = base.high == 0 ? Pair{arc.high, 0} : quick_sum(base.high, arc.high);
  const Pair sum = quick_sum(whole.high, rest);
  return sum.high + (sum.low + (whole.low + (bend + (base.low + arc.low))));
}

// The root of order `kOrder` of a positive normal number.
template <int kOrder>
double positive_root(double x) {
  constexpr double n = kOrder;
  // The bits of a double are nearly its logarithm. This gives a first guess with an error of some per cent.
  constexpr auto kOne = std::bit_cast<std::int64_t>(1.0);
  double y = std::bit_cast<double>((std::bit_cast<std::int64_t>(x) - kOne) / kOrder + kOne);
  // Halley's method cubes the error. Each step is applied as a correction, to keep the rounding error small.
  for (int i = 0; i < 3; ++i) {
    double power = y;
    for (int factor = 1; factor < kOrder; ++factor) power *= y;
    y -= y * (2 * (power - x) / ((n + 1) * power + (n - 1) * x));
  }
  return y;
}

template <int kOrder>
double odd_root(double x) {
  if (x == 0 || !std::isfinite(x)) return x;
  return std::copysign(positive_root<kOrder>(std::abs(x)), x);
}

}  // namespace

double sine(double angle) {
  if (!std::isfinite(angle)) return std::numeric_limits<double>::quiet_NaN();
  if (angle == 0) return angle;  // keeps the sign of a zero
  const Reduced reduced = reduce(angle);
  return sine_of(reduced, reduced.quarters);
}

double cosine(double angle) {
  if (!std::isfinite(angle)) return std::numeric_limits<double>::quiet_NaN();
  const Reduced reduced = reduce(angle);
  return sine_of(reduced, reduced.quarters + 1);
}

double arc_tangent(double y, double x) {
  if (!std::isfinite(x) || !std::isfinite(y)) return std::numeric_limits<double>::quiet_NaN();
  const double across = std::abs(y), along = std::abs(x);
  double angle = 0;
  if (across > along) {
    angle = arc_from({kPi / 2, kPiRest / 2}, std::signbit(x) ? 1 : -1, along, across);
  } else if (along == 0) {
    angle = std::signbit(x) ? kPi : 0;
  } else {
    angle = std::signbit(x) ? arc_from({kPi, kPiRest}, -1, across, along) : arc_from({0, 0}, 1, across, along);
  }
  return std::copysign(angle, y);
}

double cube_root(double x) { return odd_root<3>(x); }
double fifth_root(double x) { return odd_root<5>(x); }

}  // namespace netpocket
