// The phases of a capture.
#include "engine/state/phase.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace netpocket {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kNever = std::numeric_limits<double>::infinity();

TEST(Phases, OfAPocket) {
  EXPECT_EQ(pocket_phases(0, 10, 12),
            (std::vector<Phase>{{"closing", 0, 10, false}, {"closed", 10, 12, true}, {"towing", 12, kNever, false}}));
  EXPECT_EQ(pocket_phases(1, 5, kNone),
            (std::vector<Phase>{{"open", 0, 1, true}, {"closing", 1, 5, false}, {"closed", 5, kNever, true}}));
  // It may tow before it is closed; and old recordings may not know when it closes.
  EXPECT_EQ(pocket_phases(0, 10, 6), (std::vector<Phase>{{"closing", 0, 10, false}, {"towing", 6, kNever, false}}));
  EXPECT_EQ(pocket_phases(0, kNone, 6), (std::vector<Phase>{{"towing", 6, kNever, false}}));
  EXPECT_TRUE(pocket_phases(0, kNone, kNone).empty());
}

TEST(Phases, OfAChannel) {
  EXPECT_EQ(phases_of_channel({0, 1, 2, 3, 4}, {0, 0, 1, 1, 3}),
            (std::vector<Phase>{{"open", 0, 2, true}, {"closing", 2, 4, false}, {"towing", 4, kNever, false}}));
  EXPECT_EQ(phases_of_channel({0, 1, 2}, {4, 9, kNone}), (std::vector<Phase>{{"after towing", 0, 1, true}}));
  EXPECT_TRUE(phases_of_channel({}, {}).empty());
}

// What a run that is still under way shows: the present phase has no end.
TEST(Phases, ComeFrameByFrame) {
  PhaseHistory history;
  EXPECT_TRUE(history.phases().empty());
  EXPECT_TRUE(history.note(0, 0));
  EXPECT_FALSE(history.note(0.02, 0));
  EXPECT_EQ(history.phases(), (std::vector<Phase>{{"open", 0, kNever, true}}));
  EXPECT_TRUE(history.note(0.04, 1));
  EXPECT_EQ(history.phases(), (std::vector<Phase>{{"open", 0, 0.04, true}, {"closing", 0.04, kNever, false}}));
  EXPECT_TRUE(history.note(0.06, kNone));
  EXPECT_FALSE(history.note(0.08, 7));
  EXPECT_EQ(history.phases().back(), (Phase{"closing", 0.04, 0.06, false}));
  EXPECT_EQ(history.phases().size(), 2u);
}

TEST(Phases, AreFoundByNameAndTime) {
  const std::vector<Phase> phases = pocket_phases(1, 5, 8);
  EXPECT_EQ(phase_begin(phases, "towing"), 8);
  EXPECT_EQ(phase_end(phases, "closing"), 5);
  EXPECT_TRUE(std::isnan(phase_end(phases, "folding")));
  EXPECT_EQ(phase_at(phases, 0), "open");
  EXPECT_EQ(phase_at(phases, 4.999), "closing");
  EXPECT_EQ(phase_at(phases, 5), "closed");
  EXPECT_EQ(phase_at(phases, 1e9), "towing");
  EXPECT_EQ(phase_at(phases, -1), "");
  EXPECT_EQ(phase_at(pocket_phases(0, 10, 6), 7), "towing");  // the later one of two that overlap
}

}  // namespace
}  // namespace netpocket
