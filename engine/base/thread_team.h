#pragma once
// Threads that share the loops of a step: a few hundred microseconds of work, tens of thousands of times a second. A
// general scheduler puts idle threads to sleep between two loops, and waking them costs as much as they save (with
// oneTBB two threads were 1.1 to 1.3 times as fast as one at 30,000 elements). These wait awake for a moment first.
//
// Each thread begins with the same part of each loop, so that what it reads is still in its cache, and then helps the
// others: of two virtual processors one was often a quarter slower, for tens of milliseconds. The caller does
// not wait for one that sleeps, unless the loop is long: where other programs take the processors, it does the work
// alone.

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <thread>
#include <utility>
#include <vector>

namespace netpocket {

class ThreadTeam {
 public:
  // A team of `threads` (1 or more), the caller of run() among them.
  explicit ThreadTeam(int threads);
  ~ThreadTeam();
  ThreadTeam(const ThreadTeam&) = delete;
  ThreadTeam& operator=(const ThreadTeam&) = delete;

  // Calls work(first, last) with ranges that make up [0, count), some at the same time, and returns when all have
  // returned. They begin at multiples of `grain`. Before it takes its part the caller does `meanwhile`. Neither may
  // throw. To be called by one thread at a time.
  void run(int count, int grain, const std::function<void(int first, int last)>& work,
           const std::function<void()>& meanwhile = no_work);

  // Processor time that the members other than the caller have used so far, s.
  double members_cpu_seconds();

  // Where part `part` of `parts` of [0, count) begins: a thread's part.
  static int bound(int count, int part, int parts) {
    return static_cast<int>(static_cast<std::int64_t>(count) * part / parts);
  }

 private:
  using Clock = std::chrono::steady_clock;
  // Ranges of `grain` that nobody has taken yet, from the first to before the last.
  class alignas(64) Part {
   public:
    void set(int first, int last) { left_ = pack(first, last); }
    // Takes half of them, or the last one, from one of the ends: long stretches first, which processors read ahead.
    // First and end; empty when none is left.
    std::pair<int, int> take(bool from_front);

   private:
    static std::uint64_t pack(int first, int last) {
      return static_cast<std::uint64_t>(first) << 32 | static_cast<std::uint32_t>(last);
    }
    std::atomic<std::uint64_t> left_ = 0;
  };
  static void no_work() {}
  void serve(int member);
  void take_part(Part& part, bool from_front);
  void work_as(int member);
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
