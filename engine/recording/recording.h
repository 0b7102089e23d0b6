#pragma once
// Reads a recorded run, also one that is still being written: then as far as it was flushed when it was opened. Node
// data are read frame by frame, so only the channels' memory grows with the length of the run.
// Quantities are as precise as they are stored (FORMAT.md): node, element and contact data in single precision.
// Thread contract: one thread at a time per object. Errors: throws RecordingError with one sentence that names the
// file; FileError where it cannot be opened although it is there.

#include <memory>
#include <string>
#include <vector>

#include "engine/recording/recorder.h"

namespace netpocket {

class Recording {
 public:
  explicit Recording(const std::string& path);
  ~Recording();
  Recording(Recording&&) noexcept;
  Recording& operator=(Recording&&) noexcept;

  const std::string& path() const;
  const RunOrigin& origin() const;
  const Structure& structure() const;
  const RunStatus& status() const;  // reason `running` when the run was cut off
  const RunStatistics& statistics() const;

  std::size_t frame_count() const;
  const std::vector<double>& times() const;  // s, by frame
  // Those that the file has, in its order; also that of its frames' values.
  const std::shared_ptr<const ChannelList>& channels() const;
  const std::vector<double>& channel(std::size_t index) const;  // by frame
  const std::vector<double>& channel(Channel c) const;          // by frame; NaN where the file does not have it
  bool has_channel(Channel c) const;
  Snapshot frame(std::size_t index) const;
  // The contact points of a frame alone: much quicker than the whole of it.
  std::vector<ContactPoint> contacts(std::size_t index) const;
  // States from which the run can be resumed, by time.
  const std::vector<double>& checkpoint_times() const;  // s
  bool changes_strategy(std::size_t checkpoint) const;  // whether another strategy took over there
  Checkpoint checkpoint(std::size_t index) const;
  // Index of the frame nearest to a time; throws when there is no frame.
  std::size_t frame_at(double time) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace netpocket
