// Threads that share loops: every index once, whatever the threads do meanwhile.

#include "engine/base/thread_team.h"

#include <gtest/gtest.h>

#include <chrono>
#include <numeric>

namespace netpocket {
namespace {

TEST(ThreadTeam, DoesEveryIndexOnce) {
  for (const int threads : {1, 2, 3, 5}) {
    ThreadTeam team(threads);
    for (const int count : {0, 1, 7, 64, 1000}) {
      for (const int grain : {1, 16, 2000}) {
        std::vector<int> done(static_cast<std::size_t>(count), 0);
        for (int round = 1; round <= 50; ++round) {
          team.run(count, grain, [&](int first, int last) {
            ASSERT_LE(first, last);
            ASSERT_EQ(first % grain, 0);
            for (int i = first; i < last; ++i) ++done[static_cast<std::size_t>(i)];
          });
          ASSERT_EQ(std::count(done.begin(), done.end(), round), count) << threads << " threads, grain " << grain;
        }
      }
    }
  }
}

// What one round writes the next one reads, in another order.
TEST(ThreadTeam, RoundsFollowEachOther) {
  ThreadTeam team(3);
  constexpr int kCount = 300;
  std::vector<long> from(kCount), to(kCount);
  std::iota(from.begin(), from.end(), 0);
  for (int round = 0; round < 2000; ++round) {
    team.run(kCount, 10, [&](int first, int last) {
      for (int i = first; i < last; ++i)
        to[static_cast<std::size_t>(i)] = from[static_cast<std::size_t>(kCount - 1 - i)] + 1;
    });
    std::swap(from, to);
  }
  EXPECT_EQ(std::accumulate(from.begin(), from.end(), 0L), kCount * (kCount - 1) / 2 + 2000L * kCount);
}

// What the caller does meanwhile is done once, whoever does the loop.
TEST(ThreadTeam, CallerDoesSomethingElseFirst) {
  ThreadTeam team(2);
  int meanwhile = 0;
  std::atomic<int> sum = 0;
  for (int round = 0; round < 200; ++round) {
    team.run(
        50, 1, [&](int first, int last) { sum += last - first; },
        [&] {
          ++meanwhile;
          if (round % 50 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(2));
        });
  }
  EXPECT_EQ(meanwhile, 200);
  EXPECT_EQ(sum, 200 * 50);
}

// Members fall asleep between rounds and are woken; one that is away does not hold up the others for good.
TEST(ThreadTeam, RoundsMayBeFarApart) {
  ThreadTeam team(2);
  std::atomic<int> sum = 0;
  for (int round = 0; round < 20; ++round) {
    std::this_thread::sleep_for(std::chrono::milliseconds(round % 4));
    team.run(100, 1, [&](int first, int last) {
      if (first == 60 && round % 5 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(3));
      sum += last - first;
    });
  }
  EXPECT_EQ(sum, 20 * 100);
}

TEST(ThreadTeam, PartsMakeUpTheWhole) {
  EXPECT_EQ(ThreadTeam::bound(2000000000, 3, 3), 2000000000);
  EXPECT_EQ(ThreadTeam::bound(10, 0, 3), 0);
  EXPECT_EQ(ThreadTeam::bound(10, 1, 3), 3);
  EXPECT_EQ(ThreadTeam::bound(10, 2, 3), 6);
}

}  // namespace
}  // namespace netpocket
