#include "engine/dynamics/contact/spring_offsets.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace netpocket {
namespace {

// 2/5 K s^2.5, the work of K s^1.5.
double energy_of(double stiffness, double compression) {
  return compression > 0 ? 0.4 * stiffness * std::pow(compression, 2.5) : 0;
}

TEST(SpringOffsets, OneSpringKeepsItsEnergy) {
  const std::vector<ChangingSpring> springs{{0.7, 3e-3, 3e-3, 1e5, 3.2e6}};
  const double offset = offset_of_same_energy(springs);
  EXPECT_NEAR(energy_of(3.2e6, 3e-3 - offset), energy_of(1e5, 3e-3), 1e-12 * energy_of(1e5, 3e-3));
}

// Capsules of one holder are pressed to different depths, and one place takes back what two count twice.
TEST(SpringOffsets, SpringsOfAHolderKeepTheirEnergyTogether) {
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> depth(1e-3, 9e-3), share(0.2, 1);
  for (int i = 0; i < 100; ++i) {
    const double shallow = depth(generator), deep = shallow + depth(generator);
    const std::vector<ChangingSpring> springs{{share(generator), deep, deep, 1e5, 3.2e6},
                                              {share(generator), shallow, shallow, 1e5, 3.2e6},
                                              {-0.1, 0.9 * shallow, 0.9 * shallow, 1e5, 3.2e6}};
    const double offset = offset_of_same_energy(springs);
    double before = 0, after = 0;
    for (const ChangingSpring& s : springs) {
      before += s.share * energy_of(s.stiffness_before, s.compression);
      after += s.share * energy_of(s.stiffness, s.depth - offset);
    }
    EXPECT_NEAR(after, before, 1e-9 * before) << i;
  }
}

TEST(SpringOffsets, SofterSpringsBeginAtTheSurfaceAtMost) {
  const std::vector<ChangingSpring> one{{1, 2e-3, 2e-3, 3.2e6, 1e5}};
  EXPECT_EQ(offset_of_same_energy(one), 0);
  const std::vector<ChangingSpring> two{{1, 2e-3, 2e-3, 3.2e6, 1e5}, {0.5, 1e-3, 1e-3, 3.2e6, 1e5}};
  EXPECT_EQ(offset_of_same_energy(two), 0);
}

constexpr double kDepth = 5e-3, kOffset = 4e-3;

// Holders 2 and 3 of a cord touch with offsets.
SpringOffsets with_offsets() {
  SpringOffsets offsets(1, 8);
  offsets.set({{{0, 2}, kOffset}, {{0, 3}, 0.5 * kOffset}});
  return offsets;
}

TEST(SpringOffsets, FollowTheCordOutAndNotIn) {
  SpringOffsets offsets = with_offsets();
  EXPECT_EQ(offsets.follow({0, 2}, kDepth, {1, 3}, 0), kOffset);
  offsets.end_step();
  EXPECT_EQ(offsets.follow({0, 2}, 0.7 * kOffset, {1, 3}, 0), 0.7 * kOffset);
  offsets.end_step();
  EXPECT_EQ(offsets.follow({0, 2}, kDepth, {1, 3}, 0), 0.7 * kOffset);
}

TEST(SpringOffsets, HolderThatThePlaceComesToTakesItsNeighboursOffset) {
  SpringOffsets offsets = with_offsets();
  EXPECT_EQ(offsets.follow({0, 1}, kDepth, {0, 2}, 0), kOffset);
  EXPECT_EQ(offsets.follow({0, 4}, kDepth, {3, 5}, 0), 0.5 * kOffset);
  EXPECT_EQ(offsets.follow({0, 7}, kDepth, {6, -1}, 1e-3), kDepth - 1e-3) << "no neighbour touches";
  EXPECT_EQ(offsets.follow({0, 6}, 1e-3, {5, 7}, 2e-3), 0) << "it has come in by its own motion";
}

TEST(SpringOffsets, AreForgottenWithTheContact) {
  SpringOffsets offsets = with_offsets();
  EXPECT_FALSE(offsets.are_zero());
  offsets.follow({0, 3}, kDepth, {2, 4}, 0);
  offsets.end_step();
  EXPECT_EQ(offsets.of({0, 2}), 0);
  EXPECT_EQ(offsets.of({0, 3}), 0.5 * kOffset);
  offsets.end_step();
  EXPECT_TRUE(offsets.are_zero());
}

}  // namespace
}  // namespace netpocket
