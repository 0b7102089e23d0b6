#include "engine/recording/background_recorder.h"

#include <chrono>
#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <thread>
#include <variant>

namespace netpocket {
namespace {

// Interval at which the writer checks the queue. It is woken at once when this many entries wait. Waking it for each
// entry would cost the simulating thread 1 % of its time.
constexpr std::chrono::milliseconds kRest{20};
constexpr std::size_t kManyEntries = kBackgroundFrames / 2;
constexpr std::size_t kManyBytes = kBackgroundBytes / 2;

using Entry = std::variant<Snapshot, Checkpoint>;

template <typename T>
std::size_t bytes_of(const std::vector<T>& values) {
  return values.size() * sizeof(T);
}

std::size_t bytes_of(const Snapshot& s) {
  const auto numbers =
      s.positions.size() + s.velocities.size() + s.gradients.size() + s.tension.size() + s.strain.size();
  return sizeof(Snapshot) + static_cast<std::size_t>(numbers) * sizeof(double) + bytes_of(s.rope_element_length) +
         bytes_of(s.bodies) + bytes_of(s.contacts);
}

std::size_t bytes_of(const Checkpoint& c) { return sizeof(Checkpoint) + bytes_of(c.state) + c.strategy.size(); }

std::size_t bytes_of(const Entry& entry) {
  return std::visit([](const auto& value) { return bytes_of(value); }, entry);
}

}  // namespace

struct BackgroundRecorder::Impl {
  Impl(const std::string& path, const RunOrigin& origin, const Structure& structure, bool overwrite)
      : recorder(path, origin, structure, overwrite), writer([this] { write_frames(); }) {}
  ~Impl() { drain(); }

  void write_frames();
  void write(Entry entry);
  bool has_many() const { return queue.size() >= kManyEntries || bytes >= kManyBytes; }
  void drain();
  void rethrow();

  Recorder recorder;  // used only by the writer until it is joined
  std::mutex mutex;   // guards the following
  std::condition_variable changed;
  std::deque<Entry> queue;
  std::size_t bytes = 0;  // of the entries in the queue
  bool closing = false;
  std::exception_ptr failure;  // of the first frame that could not be written; later frames are dropped
  std::thread writer;
};

void BackgroundRecorder::Impl::write_frames() {
  std::unique_lock lock(mutex);
  while (true) {
    const auto is_needed = [this] { return closing || has_many(); };
    if (queue.empty()) changed.wait_for(lock, kRest, is_needed);
    if (queue.empty() && closing) return;
    if (queue.empty()) continue;
    const Entry entry = std::move(queue.front());
    queue.pop_front();
    bytes -= bytes_of(entry);
    const bool wanted = failure == nullptr;
    lock.unlock();
    changed.notify_one();
    std::exception_ptr error;
    try {
      if (wanted) {
        std::visit([this](const auto& value) { recorder.write(value); }, entry);
        // A checkpoint must not wait for the flush of the next frame.
        if (std::holds_alternative<Checkpoint>(entry)) recorder.flush();
      }
    } catch (...) {
      error = std::current_exception();
    }
    lock.lock();
    if (error) failure = error;
  }
}

void BackgroundRecorder::Impl::write(Entry entry) {
  const std::size_t size = bytes_of(entry);
  {
    std::unique_lock lock(mutex);
    changed.wait(
        lock, [&] { return queue.empty() || (queue.size() < kBackgroundFrames && bytes + size <= kBackgroundBytes); });
    rethrow();
    queue.push_back(std::move(entry));
    bytes += size;
    if (!has_many()) return;
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

void BackgroundRecorder::write(Checkpoint checkpoint) { impl_->write(std::move(checkpoint)); }

// Safe without a lock: the writer does nothing before the first frame.
void BackgroundRecorder::hold_back(std::size_t frame_count) { impl_->recorder.hold_back(frame_count); }

bool BackgroundRecorder::is_published() const { return impl_->recorder.is_published(); }

void BackgroundRecorder::finish(const RunStatus& status, const RunStatistics& statistics) {
  impl_->drain();
  if (!impl_->failure) {
    impl_->recorder.finish(status, statistics);
    return;
  }
  // If there is room on the disk, the recording states why its last frames are missing.
  try {
    impl_->recorder.finish({RunReason::storage_failed, status.time, "a frame could not be written"}, statistics);
  } catch (const FileError&) {
    // The exception thrown below says more.
  }
  impl_->rethrow();
}

}  // namespace netpocket
