#include "engine/base/thread_team.h"

#include <pthread.h>
#include <time.h>

#include <algorithm>
#include <tuple>

namespace netpocket {
namespace {

// Number of times a thread looks for work before it sleeps: about 200 us, longer than the serial work between two
// loops.
constexpr int kLooks = 20000;
// A loop for which one thread needs at least this long is shared even if members must wake first. While a member
// sleeps, the caller does shorter loops alone.
constexpr std::chrono::microseconds kWorthWaking{500};
// How long the caller accepts to wait for ranges that others have begun. If it takes longer, another program must use
// their processor. Then the caller works alone for kTimesAlone times the time it has lost.
constexpr std::chrono::microseconds kPatience{50};
constexpr int kTimesAlone = 16;
// Number of times the caller checks whether the others have finished before it yields its processor.
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

double ThreadTeam::members_cpu_seconds() {
  double sum = 0;
  for (std::jthread& member : members_) {
    clockid_t clock{};
    timespec used{};
    if (pthread_getcpuclockid(member.native_handle(), &clock) != 0 || clock_gettime(clock, &used) != 0) continue;
    sum += static_cast<double>(used.tv_sec) + 1e-9 * static_cast<double>(used.tv_nsec);
  }
  return sum;
}

std::pair<int, int> ThreadTeam::Part::take(bool from_front) {
  std::uint64_t left = left_;
  for (;;) {
    const int first = static_cast<int>(left >> 32), last = static_cast<int>(left & 0xffffffffU);
    if (first >= last) return {last, last};
    const int count = (last - first + 1) / 2;
    if (left_.compare_exchange_weak(left, from_front ? pack(first + count, last) : pack(first, last - count))) {
      return from_front ? std::pair(first, first + count) : std::pair(last - count, last);
    }
  }
}

void ThreadTeam::take_part(Part& part, bool from_front) {
  for (auto [first, last] = part.take(from_front); first < last; std::tie(first, last) = part.take(from_front)) {
    (*work_)(first * grain_, std::min(count_, last * grain_));
  }
}

// The two threads of a pair begin at the outer ends of their adjacent parts and meet in the middle. So each has about
// the same ranges in every loop, whichever is faster. Then a thread helps the others, from the opposite ends of their
// parts.
void ThreadTeam::work_as(int member) {
  take_part(parts_[static_cast<std::size_t>(member)], member % 2 == 0);
  const int partner = member ^ 1;
  if (partner < threads_) take_part(parts_[static_cast<std::size_t>(partner)], partner % 2 != 0);
  for (int other = 0; other < threads_; ++other) take_part(parts_[static_cast<std::size_t>(other)], other % 2 != 0);
}

// Whether all members are awake. If not, wakes them.
bool ThreadTeam::all_awake() {
  if (awake_ == threads_ - 1) return true;
  ++round_;
  round_.notify_all();
  return false;
}

void ThreadTeam::run(int count, int grain, const std::function<void(int, int)>& work,
                     const std::function<void()>& meanwhile) {
  const Clock::time_point begin = Clock::now();
  if (alone_) alone_ = begin < together_from_;
  if (alone_ || (!all_awake() && loop_time_ < kWorthWaking)) {
    meanwhile();
    work(0, count);
    loop_time_ = Clock::now() - begin;
    return;
  }
  count_ = count;
  grain_ = grain;
  work_ = &work;
  const int ranges = (count + grain - 1) / grain;
  for (int i = 0; i < threads_; ++i) {
    parts_[static_cast<std::size_t>(i)].set(bound(ranges, i, threads_), bound(ranges, i + 1, threads_));
  }
  open_ = true;
  ++round_;
  round_.notify_all();
  meanwhile();
  work_as(0);
  const Clock::time_point own_end = Clock::now();
  loop_time_ = threads_ * (own_end - begin);
  open_ = false;
  for (int look = 1; inside_ > 0; ++look) {
    if (look % kLooksBeforeYield == 0) std::this_thread::yield();
    relax();
  }
  const Clock::time_point end = Clock::now();
  if (end - own_end <= kPatience) return;
  alone_ = true;
  together_from_ = end + kTimesAlone * (end - own_end);
}

// A late member finds the round closed, or the next one open. In both cases it reads consistent data, because the
// caller changes nothing while a member is inside.
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
    if (open_) work_as(member);
    --inside_;
  }
}

}  // namespace netpocket
