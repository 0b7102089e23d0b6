#include "engine/dynamics/thread_team.h"

#include <algorithm>

namespace netpocket {
namespace {

// How often a thread looks for work before it sleeps: some 200 us, longer than what is done alone between two loops.
constexpr int kLooks = 20000;
// A loop that takes one thread so long is worth the time that others take to wake; shorter ones wait for the next.
constexpr std::chrono::microseconds kWorthWaking{500};
// How long the caller waits for the others' parts, besides half of what its own took, before it does the rest itself.
// Then some other program must have their processor, and it works alone for a while: as many times as long as it has
// lost.
constexpr std::chrono::microseconds kPatience{50};
constexpr int kTimesAlone = 16;
// How often it looks at the end of what is under way before it lets other programs have its own.
constexpr int kLooksBeforeYield = 200;

void relax() {
#if defined(__x86_64__) || defined(__i386__)
  __builtin_ia32_pause();
#endif
}

}  // namespace

ThreadTeam::ThreadTeam(int threads) : threads_(threads), parts_(static_cast<std::size_t>(threads)) {
  for (int member = 1; member < threads_; ++member) members_.emplace_back([this, member] { serve(member); });
}

ThreadTeam::~ThreadTeam() {
  ended_ = true;
  ++round_;
  round_.notify_all();
}

// Takes what is left of a part.
void ThreadTeam::take_ranges(Part& part) {
  for (int range = part.next++; range < part.end; range = part.next++) {
    (*work_)(range * grain_, std::min(count_, (range + 1) * grain_));
  }
}

bool ThreadTeam::all_taken() const {
  return std::ranges::all_of(parts_, [](const Part& part) { return part.next >= part.end; });
}

// Wakes who sleeps.
bool ThreadTeam::all_awake() {
  if (awake_ == threads_ - 1) return true;
  ++round_;
  round_.notify_all();
  return false;
}

void ThreadTeam::run(int count, int grain, const std::function<void(int, int)>& work) {
  const Clock::time_point begin = Clock::now();
  if (alone_) alone_ = begin < together_from_;
  if (alone_ || (!all_awake() && loop_time_ < kWorthWaking)) {
    work(0, count);
    loop_time_ = Clock::now() - begin;
    return;
  }
  count_ = count;
  grain_ = grain;
  work_ = &work;
  const int ranges = (count + grain - 1) / grain;
  for (int i = 0; i < threads_; ++i) {
    parts_[static_cast<std::size_t>(i)].next = bound(ranges, i, threads_);
    parts_[static_cast<std::size_t>(i)].end = bound(ranges, i + 1, threads_);
  }
  open_ = true;
  ++round_;
  round_.notify_all();
  take_ranges(parts_.front());
  const Clock::time_point own_end = Clock::now();
  loop_time_ = threads_ * (own_end - begin);
  const Clock::time_point deadline = own_end + kPatience + (own_end - begin) / 2;
  while (!all_taken() && Clock::now() < deadline) relax();
  for (Part& part : parts_) take_ranges(part);
  open_ = false;
  for (int look = 1; inside_ > 0; ++look) {
    if (look % kLooksBeforeYield == 0) std::this_thread::yield();
    relax();
  }
  const Clock::time_point end = Clock::now();
  if (end <= deadline) return;
  alone_ = true;
  together_from_ = end + kTimesAlone * (end - own_end);
}

// A member that comes late finds the round closed, or the next one open: either way what it reads is whole, because
// the caller does not change it while anybody is inside.
void ThreadTeam::serve(int member) {
  ++awake_;
  for (std::uint32_t seen = 0;;) {
    for (int look = 0; look < kLooks && round_ == seen; ++look) relax();
    if (round_ == seen) {
      --awake_;
      round_.wait(seen);
      ++awake_;
    }
    seen = round_;
    if (ended_) return;
    ++inside_;
    if (open_) take_ranges(parts_[static_cast<std::size_t>(member)]);
    --inside_;
  }
}

}  // namespace netpocket
