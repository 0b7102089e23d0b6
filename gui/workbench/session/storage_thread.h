#pragma once
// One thread for everything that is read from and written to recordings, so that a slow disk holds up neither the
// window nor the simulation.

#include <atomic>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

namespace netpocket {

class StorageThread {
 public:
  StorageThread();
  ~StorageThread();  // does the waiting jobs first

  // Jobs are done in order; they must not throw. Any thread.
  void post(std::function<void()> job);
  std::size_t waiting() const { return waiting_; }
  // Waits until everything posted so far is done.
  void finish();

 private:
  void run(const std::stop_token& stop);

  std::mutex mutex_;
  std::condition_variable_any changed_;
  std::deque<std::function<void()>> jobs_;
  std::atomic<std::size_t> waiting_ = 0;  // including the one being done
  std::jthread thread_;                   // last: it ends before the rest goes
};

}  // namespace netpocket
