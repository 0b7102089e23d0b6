#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include "engine/contact/broad_phase.h"
#include "engine/contact/segment_distance.h"

namespace netpocket {
namespace {

using Eigen::AlignedBox3d;
using Eigen::Vector3d;

constexpr double kCordRadius = 0.002;

// Cords and bodies thrown into a room of 10 m, in motion.
class Room {
 public:
  explicit Room(int elements, unsigned seed = 1) : random_(seed) {
    for (int i = 0; i < elements; ++i) {
      const Vector3d start = 5 * unit_cube();
      segments_.push_back({start, start + 0.5 * unit_cube()});
      velocities_.push_back(unit_cube().normalized());
    }
    for (const Shape& shape : {Shape(Sphere{3}), Shape(Box{{2, 4, 1}}), Shape(Cylinder{1, 5})}) {
      const Eigen::AngleAxisd turn(3 * unit_cube().x(), unit_cube().normalized());
      bodies_.push_back({shape, 3 * unit_cube(), turn.toRotationMatrix()});
    }
  }

  void move(double distance) {
    for (std::size_t i = 0; i < segments_.size(); ++i) {
      segments_[i].start += distance * velocities_[i];
      segments_[i].end += distance * velocities_[i];
    }
    for (PlacedShape& body : bodies_) body.position += distance * Vector3d(0.6, 0, -0.8);
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

  // Smallest distance of a cord's surface from a body, at 21 points along it: never too small.
  double clearance(std::size_t element, std::size_t body) const {
    const PlacedShape& b = bodies_[body];
    const Segment& s = segments_[element];
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= 20; ++i) {
      const Vector3d point = s.start + i / 20.0 * (s.end - s.start);
      least = std::min(least, nearest_surface_point(b.shape, b.rotation.transpose() * (point - b.position)).distance);
    }
    return least - kCordRadius;
  }

  const std::vector<Segment>& segments() const { return segments_; }
  const std::vector<PlacedShape>& bodies() const { return bodies_; }

 private:
  Vector3d unit_cube() { return {coordinate_(random_), coordinate_(random_), coordinate_(random_)}; }

  std::mt19937 random_;
  std::uniform_real_distribution<double> coordinate_{-1, 1};
  std::vector<Segment> segments_;
  std::vector<Vector3d> velocities_;
  std::vector<PlacedShape> bodies_;
};

double gap(const AlignedBox3d& a, const AlignedBox3d& b) {  // along the axis where they are farthest apart
  return (a.min() - b.max()).cwiseMax(b.min() - a.max()).maxCoeff();
}

TEST(BroadPhase, CandidatesAreThoseOfBruteForce) {
  const double margin = 0.05;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const Room room(500, seed);
    const std::vector<AlignedBox3d> boxes = room.boxes();
    BroadPhase broad_phase(500, margin);
    broad_phase.rebuild(boxes, room.bodies());
    for (std::size_t body = 0; body < room.bodies().size(); ++body) {
      const PlacedShape& b = room.bodies()[body];
      const AlignedBox3d body_box = bounding_box(b.shape, b.position, b.rotation);
      std::vector<int> expected;
      for (std::size_t i = 0; i < boxes.size(); ++i) {
        const Vector3d centre = b.rotation.transpose() * (boxes[i].center() - b.position);
        const double ball = nearest_surface_point(b.shape, centre).distance - boxes[i].diagonal().norm() / 2;
        if (gap(boxes[i], body_box) <= margin && ball <= margin) expected.push_back(static_cast<int>(i));
      }
      const std::span<const int> found = broad_phase.candidates(static_cast<int>(body));
      EXPECT_EQ(std::vector<int>(found.begin(), found.end()), expected);
      EXPECT_GT(expected.size(), 0u);
      EXPECT_LT(expected.size(), 400u);
    }
  }
}

TEST(BroadPhase, PairsAreThoseOfBruteForce) {
  const double margin = 0.05;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const Room room(500, seed);
    const std::vector<AlignedBox3d> boxes = room.boxes();
    BroadPhase broad_phase(500, margin);
    broad_phase.rebuild(boxes, room.bodies());
    std::vector<std::pair<int, int>> expected;
    for (std::size_t i = 0; i < boxes.size(); ++i)
      for (std::size_t j = i + 1; j < boxes.size(); ++j)
        if (gap(boxes[i], boxes[j]) <= margin) expected.emplace_back(i, j);
    const auto found = broad_phase.pairs();
    EXPECT_EQ((std::vector<std::pair<int, int>>(found.begin(), found.end())), expected);
    EXPECT_GT(expected.size(), 10u);
  }
}

// Backwards, in pieces: as threads might share it.
void broken_loop(int count, int grain, const std::function<void(int first, int last)>& work) {
  for (int first = (count - 1) / grain * grain; first >= 0; first -= grain) work(first, std::min(count, first + grain));
}

TEST(BroadPhase, PairsDoNotDependOnHowLoopsAreShared) {
  const Room room(5000);
  BroadPhase broad_phase(5000, 0.05);
  broad_phase.rebuild(room.boxes(), room.bodies());
  const auto pairs = broad_phase.pairs();
  EXPECT_EQ(broad_phase.pairs(broken_loop), pairs);
  EXPECT_GT(pairs.size(), 2000u);
}

TEST(BroadPhase, ListsAreKeptAsLongAsWhatHasMovedAllows) {
  const double margin = 0.05, most = (0.5 - BroadPhase::kLeastInHand) * margin;
  const Room room(20);
  BroadPhase broad_phase(20, margin);
  EXPECT_FALSE(broad_phase.keep(0, room.bodies())) << "nothing has been built";
  broad_phase.rebuild(room.boxes(), room.bodies());
  EXPECT_TRUE(broad_phase.keep(most, room.bodies()));
  EXPECT_TRUE(broad_phase.advance(0.11 * margin)) << "from there it goes on";
  EXPECT_FALSE(broad_phase.keep(1.01 * most, room.bodies()));
  EXPECT_FALSE(broad_phase.keep(std::nan(""), room.bodies()));
  auto moved = room.bodies();
  moved[1].position.x() += 1.01 * most;
  EXPECT_FALSE(broad_phase.keep(0, moved));
  moved[1].position.x() = std::nan("");
  EXPECT_FALSE(broad_phase.keep(0, moved));
  EXPECT_EQ(broad_phase.rebuild_count(), 1);
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

// The contract that matters: whatever touches is in the list, at every step, though rebuilds are rare.
TEST(BroadPhase, NothingThatTouchesIsMissedBetweenRebuilds) {
  const double margin = 0.05, step = 2e-3;
  Room room(200);
  BroadPhase broad_phase(200, margin);
  int touching = 0;
  for (int i = 0; i < 500; ++i) {
    if (broad_phase.advance(i == 0 ? 0 : step)) broad_phase.update(room.boxes(), room.bodies());
    for (std::size_t body = 0; body < room.bodies().size(); ++body) {
      const std::span<const int> found = broad_phase.candidates(static_cast<int>(body));
      for (std::size_t element = 0; element < room.segments().size(); ++element) {
        if (room.clearance(element, body) > 0) continue;
        ++touching;
        ASSERT_TRUE(std::binary_search(found.begin(), found.end(), static_cast<int>(element)));
      }
    }
    const auto pairs = broad_phase.pairs();
    for (int a = 0; a < 200; ++a) {
      for (int b = a + 1; b < 200; ++b) {
        const auto& segments = room.segments();
        if (closest_points(segments[static_cast<std::size_t>(a)], segments[static_cast<std::size_t>(b)]).distance >
            2 * kCordRadius)
          continue;
        ASSERT_TRUE(std::binary_search(pairs.begin(), pairs.end(), std::pair(a, b)));
      }
    }
    room.move(step);
  }
  EXPECT_GT(touching, 10000);
  EXPECT_EQ(broad_phase.rebuild_count(), 1 + 499 / 13);  // 13 steps of 2 mm are the first to exceed 25 mm
}

// A state that flies apart has boxes of any size before it is found out: pairs take no more memory for it.
TEST(BroadPhase, OneBoxMayReachThroughAll) {
  constexpr int kCount = 30000;
  std::vector<AlignedBox3d> boxes;
  for (int i = 0; i < kCount; ++i) boxes.emplace_back(Vector3d(i, 0, 0), Vector3d(i + 0.5, 0.1, 0.1));
  boxes.emplace_back(Vector3d(-1e8, -1e8, -1e8), Vector3d(1e8, 1e8, 1e8));
  BroadPhase broad_phase(kCount + 1, 0.2);
  broad_phase.rebuild(boxes, {});
  const auto pairs = broad_phase.pairs();
  ASSERT_EQ(pairs.size(), static_cast<std::size_t>(kCount));
  for (int i = 0; i < kCount; ++i) EXPECT_EQ(pairs[static_cast<std::size_t>(i)], std::pair(i, kCount));
}

TEST(BroadPhase, SlowMotionRebuildsRarely) {
  BroadPhase broad_phase(0, 0.05);
  int rebuilds = 0;
  for (int i = 0; i < 100000; ++i) {
    // A net closing at 0.4 m/s in steps of 0.1 ms.
    if (!broad_phase.advance(0.4 * 1e-4)) continue;
    broad_phase.rebuild({}, {});
    ++rebuilds;
  }
  EXPECT_EQ(rebuilds, 1 + 99999 / 626);  // 625 steps make half the margin, give or take round-off
  EXPECT_EQ(broad_phase.rebuild_count(), rebuilds);
}

// A vibrating cord covers a long way without going anywhere.
TEST(BroadPhase, VibrationDoesNotRebuild) {
  Room room(100);
  BroadPhase broad_phase(100, 0.05);
  int updates = 0;
  for (int i = 0; i < 1000; ++i) {
    const double step = i % 2 ? 4e-3 : -4e-3;
    room.move(step);
    if (!broad_phase.advance(std::abs(step))) continue;
    ++updates;
    EXPECT_EQ(broad_phase.update(room.boxes(), room.bodies()), updates == 1);
  }
  EXPECT_GT(updates, 100);
  EXPECT_EQ(broad_phase.rebuild_count(), 1);
}

TEST(BroadPhase, UpdateSeesElementsAndBodiesMoveAndTurn) {
  const double margin = 0.1;
  Room room(100);
  BroadPhase broad_phase(100, margin);
  EXPECT_TRUE(broad_phase.update(room.boxes(), room.bodies()));
  EXPECT_FALSE(broad_phase.update(room.boxes(), room.bodies()));

  std::vector<AlignedBox3d> boxes = room.boxes();
  boxes[42].max().z() += 0.35 * margin;
  EXPECT_FALSE(broad_phase.update(boxes, room.bodies()));
  boxes[42].max().z() += 0.1 * margin;
  EXPECT_TRUE(broad_phase.update(boxes, room.bodies()));

  std::vector<PlacedShape> bodies = room.bodies();
  bodies[1].position.y() -= 0.45 * margin;
  EXPECT_TRUE(broad_phase.update(boxes, bodies));
  const double angle = 0.45 * margin / bounding_radius(bodies[2].shape);
  bodies[2].rotation = bodies[2].rotation * Eigen::AngleAxisd(angle, Vector3d::UnitX());
  EXPECT_TRUE(broad_phase.update(boxes, bodies));
  EXPECT_EQ(broad_phase.rebuild_count(), 4);
}

TEST(BroadPhase, ListsDoNotDependOnTheHistory) {
  Room room(400);
  BroadPhase travelled(400, 0.1);
  for (int i = 0; i < 30; ++i) {
    travelled.rebuild(room.boxes(), room.bodies());
    room.move(0.1);
  }
  travelled.rebuild(room.boxes(), room.bodies());
  BroadPhase fresh(400, 0.1);
  fresh.rebuild(room.boxes(), room.bodies());
  for (int body = 0; body < 3; ++body)
    EXPECT_TRUE(std::ranges::equal(travelled.candidates(body), fresh.candidates(body)));
  EXPECT_TRUE(std::ranges::equal(travelled.pairs(), fresh.pairs()));
}

TEST(BroadPhase, RefusesWhatMakesNoSense) {
  EXPECT_THROW(BroadPhase(-1, 0.1), std::invalid_argument);
  EXPECT_THROW(BroadPhase(1, 0), std::invalid_argument);
  BroadPhase broad_phase(2, 0.1);
  EXPECT_TRUE(broad_phase.advance(0));
  const std::vector<AlignedBox3d> one(1, AlignedBox3d(Vector3d::Zero(), Vector3d::Ones()));
  EXPECT_THROW(broad_phase.rebuild(one, {}), std::invalid_argument);
  EXPECT_THROW(broad_phase.update(one, {}), std::invalid_argument);
  EXPECT_TRUE(broad_phase.advance(std::numeric_limits<double>::quiet_NaN()));
}

// A run that diverges must reach the solver's own check, not fall over here.
TEST(BroadPhase, SurvivesNumbersThatAreNotFinite) {
  Room room(50);
  std::vector<AlignedBox3d> boxes = room.boxes();
  BroadPhase broad_phase(50, 0.1);
  for (double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    boxes[7] = AlignedBox3d(Vector3d::Constant(-bad), Vector3d::Constant(bad));
    std::vector<PlacedShape> bodies = room.bodies();
    broad_phase.rebuild(boxes, bodies);
    bodies[0].position.x() = bad;
    broad_phase.rebuild(boxes, bodies);
    EXPECT_LE(broad_phase.pairs().size(), 50u * 49u / 2);
  }
}

}  // namespace
}  // namespace netpocket
