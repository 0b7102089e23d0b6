#include "engine/recording/background_recorder.h"

#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <thread>

namespace netpocket {

struct BackgroundRecorder::Impl {
  Impl(const std::string& path, const RunOrigin& origin, const Structure& structure, bool overwrite)
      : recorder(path, origin, structure, overwrite), writer([this] { write_frames(); }) {}
  ~Impl() { drain(); }

  void write_frames();
  void write(Snapshot snapshot);
  void drain();
  void rethrow();

  Recorder recorder;  // the writer's until it is joined
  std::mutex mutex;   // guards what follows
  std::condition_variable changed;
  std::deque<Snapshot> queue;
  bool closing = false;
  std::exception_ptr failure;  // of the first frame that could not be written; later ones are dropped
  std::thread writer;
};

void BackgroundRecorder::Impl::write_frames() {
  std::unique_lock lock(mutex);
  while (true) {
    changed.wait(lock, [this] { return closing || !queue.empty(); });
    if (queue.empty()) return;
    const Snapshot frame = std::move(queue.front());
    queue.pop_front();
    const bool wanted = failure == nullptr;
    lock.unlock();
    changed.notify_one();
    std::exception_ptr error;
    try {
      if (wanted) recorder.write(frame);
    } catch (...) {
      error = std::current_exception();
    }
    lock.lock();
    if (error) failure = error;
  }
}

void BackgroundRecorder::Impl::write(Snapshot snapshot) {
  {
    std::unique_lock lock(mutex);
    changed.wait(lock, [this] { return queue.size() < kBackgroundFrames; });
    rethrow();
    queue.push_back(std::move(snapshot));
  }
  changed.notify_one();
}

void BackgroundRecorder::Impl::drain() {
  if (!writer.joinable()) return;
  {
    const std::lock_guard lock(mutex);
    closing = true;
  }
  changed.notify_one();
  writer.join();
}

void BackgroundRecorder::Impl::rethrow() {
  if (failure) std::rethrow_exception(failure);
}

BackgroundRecorder::BackgroundRecorder(const std::string& path, const RunOrigin& origin, const Structure& structure,
                                       bool overwrite)
    : impl_(std::make_unique<Impl>(path, origin, structure, overwrite)) {}

BackgroundRecorder::~BackgroundRecorder() = default;

void BackgroundRecorder::write(Snapshot snapshot) { impl_->write(std::move(snapshot)); }

void BackgroundRecorder::finish(const RunStatus& status, const RunStatistics& statistics) {
  impl_->drain();
  if (!impl_->failure) {
    impl_->recorder.finish(status, statistics);
    return;
  }
  // Where there is room the recording says why it lacks its last frames.
  try {
    impl_->recorder.finish({RunReason::storage_failed, status.time, "a frame could not be written"}, statistics);
  } catch (const RecordingError&) {
    // What is thrown below says more.
  }
  impl_->rethrow();
}

}  // namespace netpocket
