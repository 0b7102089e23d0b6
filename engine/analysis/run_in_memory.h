#pragma once
// A run whose frames nobody keeps: its channels over time, in memory. Thread contract: one thread at a time per object.

#include <vector>

#include "engine/recording/run_data.h"
#include "engine/state/snapshot.h"

namespace netpocket {

class RunInMemory : public RunData {
 public:
  RunInMemory(RunOrigin origin, Structure structure);

  // Snapshots in the order of their times, with the structure's channels.
  void add(const Snapshot& snapshot);
  void finish(RunStatus status, RunStatistics statistics);

  const RunOrigin& origin() const override { return origin_; }
  const Structure& structure() const override { return structure_; }
  const RunStatus& status() const override { return status_; }
  const RunStatistics& statistics() const override { return statistics_; }
  const std::vector<double>& times() const override { return times_; }
  const std::shared_ptr<const ChannelList>& channels() const override { return structure_.channels; }
  const std::vector<double>& channel(std::size_t index) const override { return values_.at(index); }
  const std::vector<double>& channel(Channel c) const override;

 private:
  RunOrigin origin_;
  Structure structure_;
  RunStatus status_;
  RunStatistics statistics_;
  std::vector<double> times_;                // s
  std::vector<double> unknown_;              // NaN, by frame
  std::vector<std::vector<double>> values_;  // by channel and frame
};

}  // namespace netpocket
