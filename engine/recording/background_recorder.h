#pragma once
// A Recorder on a thread of its own: compressing and writing a frame does not hold up what makes the next one.
// Frames and checkpoints are written in the order in which they are given, some 20 ms later at most. They wait in a
// queue, as many as kBackgroundFrames and kBackgroundBytes allow (one always); then write() waits. What a Recorder says
// about crashes holds for the frames that have left the queue. Thread contract: one thread at a time. Errors: throws as
// a Recorder does, but a frame's failure appears at a later call.

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
  // Writes what is in the queue; see ~Recorder.
  ~BackgroundRecorder();
  BackgroundRecorder(const BackgroundRecorder&) = delete;
  BackgroundRecorder& operator=(const BackgroundRecorder&) = delete;

  void write(Snapshot snapshot);
  void write(Checkpoint checkpoint);
  // As Recorder::hold_back: before the first frame.
  void hold_back(std::size_t frame_count);
  // Writes what is in the queue, then as Recorder::finish.
  void finish(const RunStatus& status, const RunStatistics& statistics);
  bool is_published() const;  // after finish(): under the name asked for

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace netpocket
