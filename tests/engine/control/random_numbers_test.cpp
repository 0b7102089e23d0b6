// Random numbers: published integers, and the moments and tails of the distributions.

#include "engine/control/random_numbers.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace netpocket {
namespace {

// Published first outputs of SplitMix64 for the seed 1234567 (Rosetta Code, "Pseudo-random numbers/Splitmix64").
TEST(RandomNumbers, IntegersAreThoseOfSplitMix64) {
  RandomNumbers random(1234567);
  EXPECT_EQ(random.next(), 6457827717110365317U);
  EXPECT_EQ(random.next(), 3203168211198807973U);
  EXPECT_EQ(random.next(), 9817491932198370423U);
  EXPECT_EQ(random.next(), 4593380528125082431U);
  EXPECT_EQ(random.next(), 16408922859458223821U);
}

// Published counts of 5 u for 100 000 numbers with the seed 987654321 (same source).
TEST(RandomNumbers, UniformNumbersFallAsPublished) {
  RandomNumbers random(987654321);
  std::array<int, 5> counts = {};
  for (int i = 0; i < 100'000; ++i) ++counts[static_cast<std::size_t>(5 * random.uniform())];
  EXPECT_EQ(counts, (std::array{20027, 19892, 20073, 19978, 20030}));
}

// Moments and tails of the normal distribution; tolerance: 4.5 standard deviations of each estimate.
TEST(RandomNumbers, NormalNumbersHaveTheirMomentsAndTails) {
  constexpr int kCount = 1'000'000;
  RandomNumbers random(3);
  double first = 0, second = 0, third = 0, fourth = 0, product = 0, last = 0;
  int beyond_one = 0, beyond_three = 0;
  for (int i = 0; i < kCount; ++i) {
    const double x = random.normal();
    first += x;
    second += x * x;
    third += x * x * x;
    fourth += x * x * x * x;
    product += x * last;
    last = x;
    beyond_one += std::abs(x) > 1 ? 1 : 0;
    beyond_three += std::abs(x) > 3 ? 1 : 0;
  }
  const auto tolerance = [&](double variance) { return 4.5 * std::sqrt(variance / kCount); };
  EXPECT_NEAR(first / kCount, 0, tolerance(1));
  EXPECT_NEAR(second / kCount, 1, tolerance(2));
  EXPECT_NEAR(third / kCount, 0, tolerance(15));
  EXPECT_NEAR(fourth / kCount, 3, tolerance(96));
  EXPECT_NEAR(product / kCount, 0, tolerance(1));  // white
  const double one = 0.31731050786, three = 0.0026997960633;
  EXPECT_NEAR(1.0 * beyond_one / kCount, one, tolerance(one * (1 - one)));
  EXPECT_NEAR(1.0 * beyond_three / kCount, three, tolerance(three * (1 - three)));
}

}  // namespace
}  // namespace netpocket
