#pragma once
// Threads that share the loops of a step: a few hundred microseconds of work, tens of thousands of times a second. A
// general scheduler puts idle threads to sleep between two loops, and waking them costs as much as they save (with
// oneTBB two threads were 1.1 to 1.3 times as fast as one at 30,000 elements). These wait awake for a moment first.
//
// Each thread always gets the same part of a loop, so that what it reads is still in its cache. But the caller does not
// wait for one that sleeps, unless the loop is long, nor long for one that does not come: where other programs take the
// processors, it does the work alone.

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <thread>
#include <vector>

namespace netpocket {

class ThreadTeam {
 public:
  // A team of `threads` (1 or more), the caller of run() among them.
  explicit ThreadTeam(int threads);
  ~ThreadTeam();
  ThreadTeam(const ThreadTeam&) = delete;
  ThreadTeam& operator=(const ThreadTeam&) = delete;

  // Calls work(first, last) with ranges of `grain` or less that make up [0, count), some at the same time, and returns
  // when all have returned. `work` must not throw. To be called by one thread at a time.
  void run(int count, int grain, const std::function<void(int first, int last)>& work);

  // Where part `part` of `parts` of [0, count) begins: a thread's part.
  static int bound(int count, int part, int parts) {
    return static_cast<int>(static_cast<std::int64_t>(count) * part / parts);
  }

 private:
  using Clock = std::chrono::steady_clock;
  struct alignas(64) Part {
    std::atomic<int> next = 0;  // range of `grain` that nobody has taken yet
    int end = 0;
  };
  void serve(int member);
  void take_ranges(Part& part);
  bool all_taken() const;
  bool all_awake();

  int threads_;
  std::vector<Part> parts_;  // by thread
  int count_ = 0, grain_ = 1;
  const std::function<void(int, int)>* work_ = nullptr;
  std::atomic<std::uint32_t> round_ = 0;
  std::atomic<bool> open_ = false;  // whether members may take ranges
  std::atomic<bool> ended_ = false;
  std::atomic<int> awake_ = 0;   // members that do not sleep
  std::atomic<int> inside_ = 0;  // members that may be taking ranges
  Clock::duration loop_time_{};  // of the last loop, for one thread
  bool alone_ = false;           // until together_from_
  Clock::time_point together_from_{};
  std::vector<std::jthread> members_;
};

}  // namespace netpocket
