#pragma once
// Computes something in the background for the newest of a stream of inputs: while one is being computed, only the last
// of those that arrive is kept.

#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

namespace netpocket {

// Thread contract: submit() from any thread; `work` runs on the task's own thread.
template <typename Input>
class LatestTask {
 public:
  explicit LatestTask(std::function<void(const Input&)> work)
      : work_(std::move(work)), thread_([this](const std::stop_token& stop) { run(stop); }) {}

  void submit(Input input) {
    const std::lock_guard lock(mutex_);
    pending_ = std::move(input);
    changed_.notify_one();
  }

 private:
  std::optional<Input> wait(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    if (!changed_.wait(lock, stop, [this] { return pending_.has_value(); })) return std::nullopt;
    return std::exchange(pending_, std::nullopt);
  }

  void run(const std::stop_token& stop) {
    while (const auto input = wait(stop)) work_(*input);
  }

  std::function<void(const Input&)> work_;
  std::mutex mutex_;
  std::condition_variable_any changed_;
  std::optional<Input> pending_;
  std::jthread thread_;  // last: it is stopped before the rest goes
};

}  // namespace netpocket
