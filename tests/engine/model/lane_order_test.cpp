#include "engine/model/lane_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace netpocket {
namespace {

LaneItem at(int part, int place) { return {part, {place, -1, -1, -1}}; }

void expect_each_item_once(const std::vector<std::int32_t>& order) {
  std::vector<std::int32_t> sorted = order, all(order.size());
  std::ranges::sort(sorted);
  std::iota(all.begin(), all.end(), 0);
  EXPECT_EQ(sorted, all);
}

TEST(LaneOrder, PartsStandInTheirLanes) {
  std::vector<LaneItem> items;
  for (int part = 7; part >= 0; --part) {
    for (int place = 0; place < 3; ++place) items.push_back(at(part, place));
  }
  const auto order = lane_order(items);
  expect_each_item_once(order);
  for (std::size_t i = 0; i < order.size(); ++i) {
    const LaneItem& item = items[static_cast<std::size_t>(order[i])];
    EXPECT_EQ(item.part, static_cast<int>(i % 8));
    EXPECT_EQ(item.place[0], static_cast<int>(i / 8));
  }
}

TEST(LaneOrder, GapsAreFilledByItemsOfNoPart) {
  std::vector<LaneItem> items = {{}, {}, {}};
  for (int part = 0; part < 7; ++part) items.push_back(at(part, 4));
  for (int part = 0; part < 8; ++part) items.push_back(at(part, 5));
  const auto order = lane_order(items);
  expect_each_item_once(order);
  ASSERT_EQ(order.size(), 18u);
  for (std::size_t lane = 0; lane < 8; ++lane)
    EXPECT_EQ(order[lane], 10 + static_cast<int>(lane));  // complete ones first
  for (std::size_t lane = 0; lane < 7; ++lane) EXPECT_EQ(order[8 + lane], 3 + static_cast<int>(lane));
  EXPECT_EQ(order[15], 0);
  EXPECT_EQ(order[16], 1);
  EXPECT_EQ(order[17], 2);
}

// A place of two parts gives way, so that those of seven parts stand in blocks of eight.
TEST(LaneOrder, RarePlacesFillGaps) {
  std::vector<LaneItem> items;
  for (const int part : {2, 3}) items.push_back(at(part, 9));
  for (int place = 0; place < 2; ++place) {
    for (int part = 0; part < 7; ++part) items.push_back(at(part, place));
  }
  const auto order = lane_order(items);
  expect_each_item_once(order);
  for (std::size_t block = 0; block < 2; ++block) {
    for (std::size_t lane = 0; lane < 7; ++lane) {
      EXPECT_EQ(order[8 * block + lane], 2 + 7 * static_cast<int>(block) + static_cast<int>(lane));
    }
    EXPECT_EQ(order[8 * block + 7], static_cast<int>(block));
  }
}

TEST(LaneOrder, NothingHasAnOrder) { EXPECT_TRUE(lane_order({}).empty()); }

}  // namespace
}  // namespace netpocket
