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

}  // namespace
}  // namespace netpocket
