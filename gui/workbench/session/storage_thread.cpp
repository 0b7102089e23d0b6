#include "gui/workbench/session/storage_thread.h"

#include <future>
#include <memory>

namespace netpocket {

StorageThread::StorageThread() : thread_([this](const std::stop_token& stop) { run(stop); }) {}

StorageThread::~StorageThread() = default;

void StorageThread::post(std::function<void()> job) {
  const std::lock_guard lock(mutex_);
  ++waiting_;
  jobs_.push_back(std::move(job));
  changed_.notify_one();
}

// The promise belongs to both threads: that which sets it is not done with it when the other goes on.
void StorageThread::finish() {
  const auto done = std::make_shared<std::promise<void>>();
  post([done] { done->set_value(); });
  done->get_future().wait();
}

void StorageThread::run(const std::stop_token& stop) {
  while (true) {
    std::function<void()> job;
    {
      std::unique_lock lock(mutex_);
      if (!changed_.wait(lock, stop, [this] { return !jobs_.empty(); })) return;
      job = std::move(jobs_.front());
      jobs_.pop_front();
    }
    job();
    --waiting_;
  }
}

}  // namespace netpocket
