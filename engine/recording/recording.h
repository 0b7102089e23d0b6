#pragma once
// Reads a recorded run. A run that is still being written is read as far as it was flushed when it was opened. Node
// data are read frame by frame, so only the memory for channels grows with the length of the run. Quantities have the
// precision in which they are stored (FORMAT.md): node, element and contact data are in single precision.
// Thread contract: one thread at a time per object. Errors: RecordingError with one sentence that names the file;
// FileError when the file exists but cannot be opened.

#include <memory>
#include <string>
#include <vector>

#include "engine/recording/run_data.h"

namespace netpocket {

class Recording : public RunData {
 public:
  explicit Recording(const std::string& path);
  ~Recording() override;
  Recording(Recording&&) noexcept;
  Recording& operator=(Recording&&) noexcept;

  const std::string& path() const;
  const RunOrigin& origin() const override;
  const Structure& structure() const override;
  const RunStatus& status() const override;
  const RunStatistics& statistics() const override;
  const std::vector<double>& times() const override;
  const std::shared_ptr<const ChannelList>& channels() const override;
  const std::vector<double>& channel(std::size_t index) const override;
  const std::vector<double>& channel(Channel c) const override;

  Snapshot frame(std::size_t index) const;
  // Only the contact points of a frame. Much faster than frame().
  std::vector<ContactPoint> contacts(std::size_t index) const;
  // Checkpoints: states from which the run can be resumed, sorted by time.
  const std::vector<double>& checkpoint_times() const;  // s
  bool changes_strategy(std::size_t checkpoint) const;  // whether the strategy was changed at this checkpoint
  Checkpoint checkpoint(std::size_t index) const;
  // Index of the frame nearest to a time (s). Throws when there is no frame.
  std::size_t frame_at(double time) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace netpocket
