// Elementary functions of our own: how far they are from the exact value, with long doubles of the C library for it
// (whose own error is below 0.001 of a double's unit in the last place), special values, and that their bits are the
// same in every build.

#include "engine/math/elementary.h"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <functional>
#include <limits>
#include <numbers>
#include <random>

#include "engine/math/power.h"

namespace netpocket {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

// Error in units in the last place of the exact value.
double error_in_units(double value, long double exact) {
  const double size = std::abs(static_cast<double>(exact));
  const long double unit = std::nextafter(size, kInfinity) - size;
  return static_cast<double>(std::abs(value - exact) / unit);
}

using Draw = std::function<double(std::mt19937_64&)>;
Draw within(double from, double to) {
  return [=](std::mt19937_64& random) { return std::uniform_real_distribution<double>(from, to)(random); };
}
// Of either sign, their size evenly spread over powers of two.
Draw of_all_sizes(double least_power, double largest_power) {
  return [=](std::mt19937_64& random) {
    const double size = std::exp2(std::uniform_real_distribution<double>(least_power, largest_power)(random));
    return random() % 2 == 0 ? size : -size;
  };
}

template <typename Function, typename Exact>
double largest_error(const Function& function, const Exact& exact, const Draw& draw, int count = 200000) {
  std::mt19937_64 random(1);
  double largest = 0;
  for (int i = 0; i < count; ++i) {
    const double x = draw(random);
    largest = std::max(largest, error_in_units(function(x), exact(static_cast<long double>(x))));
  }
  return largest;
}

TEST(Elementary, SineAndCosineAreGoodToAUnitInTheLastPlace) {
  const auto exact_sine = [](long double x) { return std::sin(x); };
  const auto exact_cosine = [](long double x) { return std::cos(x); };
  for (const Draw& draw : {within(-7, 7), within(-1e5, 1e5), of_all_sizes(-300, 3)}) {
    EXPECT_LT(largest_error(sine, exact_sine, draw), 0.85);      // measured 0.78
    EXPECT_LT(largest_error(cosine, exact_cosine, draw), 0.85);  // 0.78
  }
}

TEST(Elementary, SineAndCosineNearMultiplesOfARightAngle) {
  for (int i = -3000; i <= 3000; ++i) {
    const double angle = i * (std::numbers::pi / 2);
    for (const double x : {angle, std::nextafter(angle, kInfinity), std::nextafter(angle, -kInfinity)}) {
      if (x == 0) continue;
      EXPECT_LT(error_in_units(sine(x), std::sin(static_cast<long double>(x))), 1) << i;
      EXPECT_LT(error_in_units(cosine(x), std::cos(static_cast<long double>(x))), 1) << i;
    }
  }
}

TEST(Elementary, SineAndCosineAreOddAndEvenToTheLastBit) {
  std::mt19937_64 random(2);
  for (int i = 0; i < 10000; ++i) {
    const double x = within(0, 100)(random);
    EXPECT_EQ(sine(-x), -sine(x));
    EXPECT_EQ(cosine(-x), cosine(x));
  }
}

TEST(Elementary, SineAndCosineOfSpecialAngles) {
  EXPECT_EQ(sine(0), 0);
  EXPECT_TRUE(std::signbit(sine(-0.0)));
  EXPECT_EQ(cosine(0), 1);
  EXPECT_EQ(sine(std::numbers::pi / 2), 1);
  EXPECT_EQ(cosine(std::numbers::pi), -1);
  for (const double x : {kInfinity, -kInfinity, kNone}) {
    EXPECT_TRUE(std::isnan(sine(x)));
    EXPECT_TRUE(std::isnan(cosine(x)));
  }
  EXPECT_LE(std::abs(sine(1e300)), 1);
  EXPECT_LE(std::abs(cosine(std::numeric_limits<double>::max())), 1);
}

TEST(Elementary, ArcTangentIsGoodToOneAndAHalfUnits) {
  const auto of_ratio = [](double y) { return arc_tangent(y, 1.0); };
  const auto exact_of_ratio = [](long double y) { return std::atan2(y, 1.0L); };
  for (const Draw& draw : {within(-2, 2), of_all_sizes(-300, 300)})
    EXPECT_LT(largest_error(of_ratio, exact_of_ratio, draw), 1.1);
  std::mt19937_64 random(3);
  double largest = 0;
  for (int i = 0; i < 300000; ++i) {
    const double x = of_all_sizes(-3, 3)(random), y = of_all_sizes(-3, 3)(random);
    largest = std::max(largest, error_in_units(arc_tangent(y, x),
                                               std::atan2(static_cast<long double>(y), static_cast<long double>(x))));
  }
  EXPECT_LT(largest, 1.5);
}

TEST(Elementary, ArcTangentOfSpecialPoints) {
  for (const double y : {0.0, -0.0, 1.0, -1.0, 1e-320, 1e300}) {
    for (const double x : {0.0, -0.0, 1.0, -1.0, 1e-320, -1e300}) {
      EXPECT_NEAR(arc_tangent(y, x), std::atan2(y, x), 5e-16) << y << ' ' << x;
      EXPECT_EQ(std::signbit(arc_tangent(y, x)), std::signbit(y)) << y << ' ' << x;
    }
  }
  EXPECT_EQ(arc_tangent(0, 1), 0);
  EXPECT_EQ(arc_tangent(0, -1), std::numbers::pi);
  EXPECT_EQ(arc_tangent(2, 0), std::numbers::pi / 2);
  EXPECT_EQ(arc_tangent(3, 3), std::numbers::pi / 4);
  EXPECT_TRUE(std::isnan(arc_tangent(kNone, 1)));
  EXPECT_TRUE(std::isnan(arc_tangent(1, kInfinity)));
}

TEST(Elementary, RootsAreGoodToAUnitInTheLastPlace) {
  EXPECT_LT(largest_error(
                cube_root, [](long double x) { return std::cbrt(x); }, of_all_sizes(-1000, 1000)),
            1);
  const auto exact_fifth = [](long double x) { return std::copysign(std::pow(std::abs(x), 0.2L), x); };
  EXPECT_LT(largest_error(fifth_root, exact_fifth, of_all_sizes(-1000, 1000)), 1);
  for (const double x : {0.0, 1.0, -1.0, 2.0, 3.0, -5.0, 10.0}) {
    EXPECT_EQ(cube_root(x * x * x), x);
    EXPECT_NEAR(fifth_root(x * x * x * x * x), x, 1e-15 * std::abs(x));
  }
  EXPECT_EQ(cube_root(kInfinity), kInfinity);
  EXPECT_TRUE(std::isnan(fifth_root(kNone)));
}

TEST(Elementary, HypotenuseAndFourthPower) {
  const auto own = [](double x) { return hypotenuse(x, 1.75); };
  const auto exact = [](long double x) { return std::sqrt(x * x + 1.75L * 1.75L); };
  EXPECT_LT(largest_error(own, exact, of_all_sizes(-20, 20)), 1.5);
  EXPECT_EQ(hypotenuse(3, 4), 5);
  EXPECT_EQ(fourth_power(3), 81);
}

// Rounded correctly, up to what the reference can tell.
TEST(Power, LogarithmAndPowersAreTheNearestDoubles) {
  const auto positive = [](double least, double largest) {
    return [=](std::mt19937_64& random) { return std::abs(of_all_sizes(least, largest)(random)); };
  };
  EXPECT_LT(largest_error(
                logarithm, [](long double x) { return std::log(x); }, positive(-500, 500), 20000),
            0.502);
  EXPECT_LT(largest_error(
                logarithm, [](long double x) { return std::log(x); }, within(0.9, 1.1), 20000),
            0.502);
  for (const double exponent : {0.4, -2.5, 1.0 / 3, 17.0}) {
    const auto own = [=](double x) { return power(x, exponent); };
    const auto exact = [=](long double x) { return std::pow(x, static_cast<long double>(exponent)); };
    EXPECT_LT(largest_error(own, exact, positive(-30, 30), 20000), 0.51) << exponent;
  }
}

TEST(Power, SpecialValues) {
  for (const double x : {1e-3, 0.7, 1.0, 2.0, 123.4}) {
    EXPECT_EQ(power(x, 0), 1);
    EXPECT_EQ(power(x, 1), x);
    EXPECT_EQ(power(x, 2), x * x);
  }
  EXPECT_EQ(logarithm(1), 0);
  EXPECT_EQ(logarithm(0), -kInfinity);
  EXPECT_EQ(logarithm(kInfinity), kInfinity);
  EXPECT_TRUE(std::isnan(logarithm(-1)));
  EXPECT_EQ(power(10, 400), kInfinity);
  EXPECT_EQ(power(10, -400), 0);
  EXPECT_EQ(power(2, -1074), std::numeric_limits<double>::denorm_min());
  EXPECT_TRUE(std::isnan(power(-1, 0.5)));
  EXPECT_TRUE(std::isnan(power(kNone, 1)));
}

// The bits of 20,000 results each. They differ only where the arithmetic is not IEEE 754's, or where a function was
// changed on purpose.
TEST(Elementary, GivesTheBitsItAlwaysGave) {
  std::uint64_t hash = 14695981039346656037ULL;
  const auto add = [&](double value) { hash = (hash ^ std::bit_cast<std::uint64_t>(value)) * 1099511628211ULL; };
  for (int i = 1; i <= 20000; ++i) {
    const double x = i * 0x1.89p-10;
    add(sine(x));
    add(cosine(x));
    add(arc_tangent(x - 10, 3.7));
    add(cube_root(x));
    add(fifth_root(x));
    if (i % 20 != 0) continue;
    add(logarithm(x));
    add(power(x, 0.37));
  }
  EXPECT_EQ(hash, 0x1f4dcb9e8922741dULL) << std::hex << hash;
}

}  // namespace
}  // namespace netpocket
