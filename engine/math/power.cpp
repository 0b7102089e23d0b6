#include "engine/math/power.h"

#include <cmath>
#include <limits>

namespace netpocket {
namespace {

// The unevaluated sum of two doubles. The second is at most half a unit in the last place of the first, which gives
// about 104 bits (Dekker 1971, Numer. Math. 18, doi:10.1007/BF01397083).
struct Double2 {
  double high = 0, low = 0;
};

// The sum and its rounding error.
Double2 exact_sum(double a, double b) {
  const double sum = a + b, part = sum - a;
  return {sum, (a - (sum - part)) + (b - part)};
}

Double2 exact_product(double a, double b) {
  const auto upper_half = [](double x) {
    const double shifted = 134217729.0 * x;  // 2^27 + 1
    return shifted - (shifted - x);
  };
  const double product = a * b;
  const double a1 = upper_half(a), a2 = a - a1, b1 = upper_half(b), b2 = b - b1;
  return {product, ((a1 * b1 - product) + a1 * b2 + a2 * b1) + a2 * b2};
}

Double2 normalised(double high, double low) {
  const double sum = high + low;
  return {sum, low - (sum - high)};
}

Double2 operator+(const Double2& a, const Double2& b) {
  const Double2 high = exact_sum(a.high, b.high), low = exact_sum(a.low, b.low);
  const Double2 sum = normalised(high.high, high.low + low.high);
  return normalised(sum.high, sum.low + low.low);
}
Double2 operator-(const Double2& a) { return {-a.high, -a.low}; }
Double2 operator-(const Double2& a, const Double2& b) { return a + -b; }

Double2 operator*(const Double2& a, const Double2& b) {
  const Double2 product = exact_product(a.high, b.high);
  return normalised(product.high, product.low + (a.high * b.low + a.low * b.high));
}
Double2 operator*(const Double2& a, double b) { return a * Double2{b, 0}; }

Double2 operator/(const Double2& a, const Double2& b) {
  const double first = a.high / b.high;
  const Double2 rest = a - b * first;
  const double second = rest.high / b.high;
  const Double2 last = rest - b * second;
  return normalised(first, second) + Double2{last.high / b.high, 0};
}

constexpr Double2 kLogarithmOf2 = {0x1.62e42fefa39efp-1, 0x1.abc9e3b39803fp-56};

// With x = m 2^e and s = (m - 1)/(m + 1), |s| < 0.172: ln x = e ln 2 + 2 (s + s^3/3 + ...).
Double2 logarithm_of(double x) {
  int exponent = 0;
  double m = std::frexp(x, &exponent);
  if (m < 0.70710678) {
    m *= 2;
    --exponent;
  }
  const Double2 s = Double2{m - 1, 0} / exact_sum(m, 1);
  const Double2 z = s * s;
  Double2 sum;
  for (int i = 20; i >= 0; --i) sum = sum * z + Double2{1, 0} / Double2{2.0 * i + 1, 0};
  return kLogarithmOf2 * exponent + s * sum * 2.0;
}

// With x = k ln 2 + 16 r: e^x = 2^k (e^r)^16.
double exponential_of(const Double2& x) {
  constexpr double kLargest = 710, kLeast = -746;  // beyond these the result is infinite or zero
  if (x.high > kLargest) return std::numeric_limits<double>::infinity();
  if (x.high < kLeast) return 0;
  const double k = std::floor(x.high / kLogarithmOf2.high + 0.5);
  const Double2 r = (x - kLogarithmOf2 * k) * 0.0625;
  Double2 sum = {1, 0};
  for (int i = 14; i >= 1; --i) sum = Double2{1, 0} + sum * r / Double2{static_cast<double>(i), 0};
  for (int i = 0; i < 4; ++i) sum = sum * sum;
  return std::ldexp(sum.high, static_cast<int>(k));
}

}  // namespace

double logarithm(double x) {
  if (x == 0) return -std::numeric_limits<double>::infinity();
  if (!(x > 0) || std::isinf(x)) return x > 0 ? x : std::numeric_limits<double>::quiet_NaN();
  return logarithm_of(x).high;
}

double power(double x, double y) {
  if (!(x > 0) || std::isinf(x) || !std::isfinite(y)) return std::numeric_limits<double>::quiet_NaN();
  const double rough = y * std::fmax(1, std::abs(logarithm_of(x).high));
  if (!std::isfinite(rough)) return std::numeric_limits<double>::quiet_NaN();
  return exponential_of(logarithm_of(x) * y);
}

}  // namespace netpocket
