#pragma once
// What a run came to, besides its frames: its origin, its structure, its channels over time and how it ended. A
// Recording reads it from a file; a run whose frames nobody keeps holds it in memory (RunInMemory, analysis). Whatever
// needs no frames evaluates both alike. Thread contract: one thread at a time per object.

#include <memory>
#include <vector>

#include "engine/recording/recorder.h"

namespace netpocket {

class RunData {
 public:
  virtual ~RunData() = default;

  virtual const RunOrigin& origin() const = 0;
  virtual const Structure& structure() const = 0;
  virtual const RunStatus& status() const = 0;  // reason `running` when the run was cut off
  virtual const RunStatistics& statistics() const = 0;

  virtual const std::vector<double>& times() const = 0;  // s, by frame
  // The channels of the run, in their order. The channel values of frames have the same order.
  virtual const std::shared_ptr<const ChannelList>& channels() const = 0;
  virtual const std::vector<double>& channel(std::size_t index) const = 0;  // by frame
  virtual const std::vector<double>& channel(Channel c) const = 0;  // by frame; NaN when the run does not have it

  std::size_t frame_count() const { return times().size(); }
  bool has_channel(Channel c) const { return channels()->has(c); }

 protected:
  RunData() = default;
  RunData(const RunData&) = default;
  RunData(RunData&&) = default;
  RunData& operator=(const RunData&) = default;
  RunData& operator=(RunData&&) = default;
};

}  // namespace netpocket
