#pragma once
// A Recorder on its own thread, so that compressing and writing a frame does not delay the simulation of the next one.
// Frames and checkpoints are written in the order given, about 20 ms later at most. They wait in a queue, which holds
// up to kBackgroundFrames and kBackgroundBytes, but always at least one. When it is full, write() waits. The guarantees
// of Recorder about crashes apply to frames that have left the queue.
// Thread contract: one thread at a time. Errors: as Recorder, but the failure of a frame is thrown by a later call.

#include <memory>
#include <string>

#include "engine/recording/recorder.h"

namespace netpocket {

inline constexpr std::size_t kBackgroundFrames = 32;
inline constexpr std::size_t kBackgroundBytes = std::size_t{64} << 20;

class BackgroundRecorder {
 public:
  // Begins the recording before it returns: see Recorder.
  BackgroundRecorder(const std::string& path, const RunOrigin& origin, const Structure& structure, bool overwrite);
  // Writes what is in the queue. See ~Recorder.
  ~BackgroundRecorder();
  BackgroundRecorder(const BackgroundRecorder&) = delete;
  BackgroundRecorder& operator=(const BackgroundRecorder&) = delete;

  void write(Snapshot snapshot);
  void write(Checkpoint checkpoint);
  // Like Recorder::hold_back. To be called before the first frame.
  void hold_back(std::size_t frame_count);
  // Writes what is in the queue, then acts like Recorder::finish.
  void finish(const RunStatus& status, const RunStatistics& statistics);
  bool is_published() const;  // to be called after finish(): whether the recording has its final name

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace netpocket
