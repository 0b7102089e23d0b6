#include "engine/dynamics/contact/cord_offsets.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace netpocket {
namespace {

using Capsule = CordOffsets::Capsule;

// Capsules 10 to 12 of one cord and 20 to 22 of another.
const Capsule kOne{11, 10, 12}, kOther{21, 20, 22};

CordOffsets offsets_with(const CordOffsets::Place& place, double offset) {
  CordOffsets offsets;
  offsets.begin_step();
  offsets.note(place, offset);
  offsets.end_step();
  return offsets;
}

TEST(CordOffsets, ContactThatHasEnteredByItsMotionBeginsAtTheSurface) {
  const CordOffsets offsets;
  EXPECT_EQ(offsets.follow(kOne, kOther, 1e-3, 1e-3), 0);
  EXPECT_EQ(offsets.follow(kOne, kOther, -1e-3, 0), 0);
}

TEST(CordOffsets, ContactThatAppearsDeepBeginsWhereItIs) {
  const CordOffsets offsets;
  EXPECT_EQ(offsets.follow(kOne, kOther, 3e-3, 0), 3e-3);
  EXPECT_DOUBLE_EQ(offsets.follow(kOne, kOther, 3e-3, 1e-3), 2e-3);
}

TEST(CordOffsets, ContactGoesOnWhereItWas) {
  const CordOffsets offsets = offsets_with({11, 21}, 2e-3);
  EXPECT_EQ(offsets.follow(kOne, kOther, 3e-3, 0), 2e-3);
  EXPECT_EQ(offsets.follow(kOther, kOne, 3e-3, 0), 2e-3) << "whichever comes first";
  EXPECT_EQ(offsets.follow(kOne, kOther, 1e-3, 0), 1e-3) << "the spring does not pull";
  EXPECT_EQ(offsets_with({11, 21}, 0).follow(kOne, kOther, 3e-3, 0), 0) << "pressed slowly";
}

TEST(CordOffsets, ContactGoesOnAlongItsCords) {
  for (const CordOffsets::Place& before : {CordOffsets::Place{10, 21}, {12, 20}, {11, 22}}) {
    EXPECT_EQ(offsets_with(before, 2e-3).follow(kOne, kOther, 3e-3, 0), 2e-3);
  }
  EXPECT_EQ(offsets_with({13, 21}, 2e-3).follow(kOne, kOther, 3e-3, 0), 3e-3) << "another contact";
  EXPECT_EQ(offsets_with({-1, 21}, 2e-3).follow({11, -1, 12}, kOther, 3e-3, 0), 2e-3);
}

TEST(CordOffsets, TwoContactsThatBecomeOneKeepTheSmallerOffset) {
  CordOffsets offsets;
  offsets.begin_step();
  offsets.note({12, 21}, 2e-3);
  offsets.note({10, 21}, 1e-3);
  offsets.end_step();
  EXPECT_EQ(offsets.follow(kOne, kOther, 3e-3, 0), 1e-3);
}

TEST(CordOffsets, StateIsSavedAndRestored) {
  CordOffsets offsets;
  offsets.begin_step();
  offsets.note({12, 21}, 2e-3);
  offsets.note({3, 4}, 0);
  offsets.end_step();
  std::vector<double> numbers;
  offsets.visit_state([&](double& number) { numbers.push_back(number); });
  ASSERT_EQ(numbers.size(), 7U);
  CordOffsets restored;
  std::size_t next = 0;
  restored.visit_state([&](double& number) { number = numbers[next++]; });
  EXPECT_EQ(next, numbers.size());
  EXPECT_EQ(restored.follow({12, 11, -1}, kOther, 3e-3, 0), 2e-3);
  EXPECT_EQ(restored.follow({3, -1, -1}, {4, -1, -1}, 3e-3, 0), 0);
}

TEST(CordOffsets, NumbersThatAreNoneOfAStateDoNoHarm) {
  for (const double number : {-1.0, 1e300, std::numeric_limits<double>::quiet_NaN()}) {
    CordOffsets offsets;
    offsets.visit_state([&](double& visited) { visited = number; });
    EXPECT_EQ(offsets.follow(kOne, kOther, 3e-3, 0), 3e-3);
  }
}

}  // namespace
}  // namespace netpocket
