#include "engine/sampling/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "engine/sampling/permutation.h"

namespace netpocket {
namespace {

// Known answers of the authors' library Random123, file kat_vectors.
TEST(Philox, GivesThePublishedWords) {
  constexpr std::uint32_t kOnes = 0xffffffff;
  EXPECT_EQ(philox({0, 0, 0, 0}, {0, 0}), (PhiloxCounter{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
  EXPECT_EQ(philox({kOnes, kOnes, kOnes, kOnes}, {kOnes, kOnes}),
            (PhiloxCounter{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
  EXPECT_EQ(philox({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}),
            (PhiloxCounter{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
}

TEST(RandomFraction, DependsOnEveryPartOfItsAddress) {
  std::set<double> seen;
  constexpr std::uint64_t kFar = std::uint64_t{1} << 40;
  for (const std::uint64_t seed : {std::uint64_t{0}, std::uint64_t{1}, kFar}) {
    for (const std::uint64_t point : {std::uint64_t{0}, std::uint64_t{1}, kFar}) {
      for (const std::uint32_t number : {0u, 1u, 1000u}) {
        seen.insert(random_fraction(seed, point, number));
        seen.insert(random_fraction(seed, point, number, RandomPurpose::shift));
      }
    }
  }
  EXPECT_EQ(seen.size(), 54u);
  EXPECT_GT(*seen.begin(), 0);
  EXPECT_LT(*seen.rbegin(), 1);
}

TEST(RandomSequence, HasTheMomentsOfItsDistributions) {
  RandomSequence random(7);
  constexpr int kCount = 100000;
  double sum = 0, squares = 0, normals = 0, normal_squares = 0;
  for (int i = 0; i < kCount; ++i) {
    const double u = random.fraction(), z = random.normal();
    sum += u / kCount;
    squares += u * u / kCount;
    normals += z / kCount;
    normal_squares += z * z / kCount;
  }
  // Four standard errors.
  EXPECT_NEAR(sum, 0.5, 4 * 0.2887 / std::sqrt(kCount));
  EXPECT_NEAR(squares, 1.0 / 3, 4 * 0.2981 / std::sqrt(kCount));
  EXPECT_NEAR(normals, 0, 4 / std::sqrt(kCount));
  EXPECT_NEAR(normal_squares, 1, 4 * std::sqrt(2.0 / kCount));
}

TEST(RandomSequence, DrawsWholeNumbersAlike) {
  RandomSequence random(3);
  std::vector<int> counts(6);
  constexpr int kDraws = 60000;
  for (int i = 0; i < kDraws; ++i) ++counts.at(random.below(6));
  double chi_squared = 0;
  for (const int count : counts) chi_squared += (count - 1e4) * (count - 1e4) / 1e4;
  EXPECT_LT(chi_squared, 20.5);  // 0.1 % point for 5 degrees of freedom
  EXPECT_EQ(random.below(1), 0u);
}

TEST(Permuted, HoldsEveryNumberOnce) {
  for (const std::uint64_t count : {1, 2, 3, 4, 5, 17, 64, 1000}) {
    std::set<std::uint64_t> numbers;
    for (std::uint64_t place = 0; place < count; ++place) numbers.insert(permuted(place, count, 11, 2));
    EXPECT_EQ(numbers.size(), count);
    EXPECT_LT(*numbers.rbegin(), count);
  }
}

// Each number is as likely at each place.
TEST(Permuted, FavoursNoNumber) {
  constexpr std::uint64_t kCount = 5;
  constexpr std::uint64_t kSeeds = 5000;
  for (std::uint64_t place = 0; place < kCount; ++place) {
    std::vector<double> counts(kCount);
    for (std::uint64_t seed = 0; seed < kSeeds; ++seed) ++counts.at(permuted(place, kCount, seed, 0));
    double chi_squared = 0;
    for (const double count : counts) chi_squared += (count - 1000) * (count - 1000) / 1000;
    EXPECT_LT(chi_squared, 23.5) << place;  // 0.01 % point for 4 degrees of freedom
  }
}

}  // namespace
}  // namespace netpocket
