#pragma once
// Threads that share the loops of a step: a few hundred microseconds of work, tens of thousands of times a second.
//
// A general scheduler puts idle threads to sleep between two loops, and waking them costs as much as they save (with
// oneTBB two threads were 1.1 to 1.3 times as fast as one at 30,000 elements). The threads here wait awake for a moment
// before they sleep.
//
// Each thread begins with the same part of every loop, so that its data is still in its cache. Then it helps the
// others, because one of two virtual processors was often a quarter slower for tens of milliseconds. Unless the loop is
// long, the caller does not wait for a thread that sleeps. If other programs take the processors, the caller does the
// work alone.

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
  // A team of `threads` threads (1 or more), including the caller of run().
  explicit ThreadTeam(int threads);
  ~ThreadTeam();
  ThreadTeam(const ThreadTeam&) = delete;
  ThreadTeam& operator=(const ThreadTeam&) = delete;

  // Calls work(first, last) for ranges that together cover [0, count), several at the same time. Returns when all calls
  // have returned. Ranges begin at multiples of `grain`. The caller runs `meanwhile` before it takes its part. Neither
  // function may throw. Only one thread at a time may call this.
  void run(int count, int grain, const std::function<void(int first, int last)>& work,
           const std::function<void()>& meanwhile = no_work);

  // Processor time that the members other than the caller have used so far, s.
  double members_cpu_seconds();

  // Begin of part `part` when [0, count) is divided into `parts` nearly equal parts.
  static int bound(int count, int part, int parts) {
    return static_cast<int>(static_cast<std::int64_t>(count) * part / parts);
  }

 private:
  using Clock = std::chrono::steady_clock;
  // The ranges [first, last) of a thread's part that no thread has taken yet, as indices of ranges of `grain`.
  class alignas(64) Part {
   public:
    void set(int first, int last) { left_ = pack(first, last); }
    // Takes half of them (rounded up) from one end and returns their first and end; an empty pair if none is left. Long
    // stretches come first, because processors prefetch them.
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
  std::atomic<int> awake_ = 0;   // number of members that do not sleep
  std::atomic<int> inside_ = 0;  // number of members that may be taking ranges
  Clock::duration loop_time_{};  // of the last loop, if one thread did it
  bool alone_ = false;           // whether the caller works alone until together_from_
  Clock::time_point together_from_{};
  std::vector<std::jthread> members_;
};

}  // namespace netpocket
