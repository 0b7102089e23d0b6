#include "engine/contact/near_pairs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "engine/bodies/segment_distance.h"

namespace netpocket {
namespace {

using Eigen::AlignedBox3d;
using Eigen::Vector3d;

constexpr double kCordRadius = 0.002;

// Cords thrown into a room of 10 m.
class Room {
 public:
  explicit Room(int elements, unsigned seed = 1) : random_(seed) {
    for (int i = 0; i < elements; ++i) {
      const Vector3d start = 5 * unit_cube();
      segments_.push_back({start, start + 0.5 * unit_cube()});
    }
  }

  std::vector<AlignedBox3d> boxes() const {
    std::vector<AlignedBox3d> boxes;
    for (const Segment& s : segments_) {
      AlignedBox3d box(s.start);
      box.extend(s.end);
      boxes.emplace_back(box.min().array() - kCordRadius, box.max().array() + kCordRadius);
    }
    return boxes;
  }

  const std::vector<Segment>& segments() const { return segments_; }

 private:
  Vector3d unit_cube() { return {coordinate_(random_), coordinate_(random_), coordinate_(random_)}; }

  std::mt19937 random_;
  std::uniform_real_distribution<double> coordinate_{-1, 1};
  std::vector<Segment> segments_;
};

double gap(const AlignedBox3d& a, const AlignedBox3d& b) {  // along the axis where they are farthest apart
  return (a.min() - b.max()).cwiseMax(b.min() - a.max()).maxCoeff();
}

TEST(NearPairs, PairsAreThoseOfBruteForce) {
  const double margin = 0.05;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const Room room(500, seed);
    const std::vector<AlignedBox3d> boxes = room.boxes();
    std::vector<std::pair<int, int>> expected;
    for (std::size_t i = 0; i < boxes.size(); ++i)
      for (std::size_t j = i + 1; j < boxes.size(); ++j)
        if (gap(boxes[i], boxes[j]) <= margin) expected.emplace_back(i, j);
    const auto found = near_pairs(boxes, margin);
    EXPECT_EQ((std::vector<std::pair<int, int>>(found.begin(), found.end())), expected);
    EXPECT_GT(expected.size(), 10u);
  }
}

// Backwards, in pieces: as threads might share it.
void broken_loop(int count, int grain, const std::function<void(int first, int last)>& work) {
  for (int first = (count - 1) / grain * grain; first >= 0; first -= grain) work(first, std::min(count, first + grain));
}

TEST(NearPairs, PairsDoNotDependOnHowLoopsAreShared) {
  const Room room(5000);
  const std::vector<AlignedBox3d> boxes = room.boxes();
  const auto pairs = near_pairs(boxes, 0.05);
  EXPECT_EQ(near_pairs(boxes, 0.05, broken_loop), pairs);
  EXPECT_GT(pairs.size(), 2000u);
}

TEST(DividedLoop, WhatRangesFindComesInTheirOrder) {
  const auto odd_numbers = [](int first, int last, std::vector<int>& found) {
    for (int i = first; i < last; ++i) {
      if (i % 2 == 1) found.push_back(i);
    }
  };
  EXPECT_EQ(found_in_ranges<int>(broken_loop, 10, 3, odd_numbers), (std::vector<int>{1, 3, 5, 7, 9}));
  EXPECT_TRUE(found_in_ranges<int>(broken_loop, 0, 3, odd_numbers).empty());
  const auto count = [](int first, int last) { return last - first; };
  EXPECT_EQ(values_of_ranges<int>(broken_loop, 10, 4, count), (std::vector<int>{4, 4, 2}));
  EXPECT_EQ(values_of_ranges<int>(undivided_loop, 10, 4, count), (std::vector<int>{4, 4, 2}));
}

TEST(NearPairs, AllCordsThatTouchAreAmongThem) {
  int touching = 0;
  for (unsigned seed = 1; seed <= 10; ++seed) {
    const Room room(1000, seed);
    const double apart = 0.05;  // between axes
    const auto pairs = near_pairs(room.boxes(), apart);
    const auto& segments = room.segments();
    for (int a = 0; a < 1000; ++a) {
      for (int b = a + 1; b < 1000; ++b) {
        if (closest_points(segments[static_cast<std::size_t>(a)], segments[static_cast<std::size_t>(b)]).distance >
            apart)
          continue;
        ++touching;
        ASSERT_TRUE(std::binary_search(pairs.begin(), pairs.end(), std::pair(a, b)));
      }
    }
  }
  EXPECT_GT(touching, 50);
}

// A state that flies apart has boxes of any size before it is found out: pairs take no more memory for it.
TEST(NearPairs, OneBoxMayReachThroughAll) {
  constexpr int kCount = 30000;
  std::vector<AlignedBox3d> boxes;
  for (int i = 0; i < kCount; ++i) boxes.emplace_back(Vector3d(i, 0, 0), Vector3d(i + 0.5, 0.1, 0.1));
  boxes.emplace_back(Vector3d(-1e8, -1e8, -1e8), Vector3d(1e8, 1e8, 1e8));
  const auto pairs = near_pairs(boxes, 0.2);
  ASSERT_EQ(pairs.size(), static_cast<std::size_t>(kCount));
  for (int i = 0; i < kCount; ++i) EXPECT_EQ(pairs[static_cast<std::size_t>(i)], std::pair(i, kCount));
}

}  // namespace
}  // namespace netpocket
