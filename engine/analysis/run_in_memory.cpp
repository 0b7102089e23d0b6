#include "engine/analysis/run_in_memory.h"

#include <limits>

namespace netpocket {

RunInMemory::RunInMemory(RunOrigin origin, Structure structure)
    : origin_(std::move(origin)), structure_(std::move(structure)), values_(structure_.channels->size()) {}

void RunInMemory::add(const Snapshot& snapshot) {
  times_.push_back(snapshot.time);
  unknown_.push_back(std::numeric_limits<double>::quiet_NaN());
  for (std::size_t i = 0; i < values_.size(); ++i) values_[i].push_back(snapshot.channels.at(i));
}

void RunInMemory::finish(RunStatus status, RunStatistics statistics) {
  status_ = std::move(status);
  statistics_ = std::move(statistics);
}

const std::vector<double>& RunInMemory::channel(Channel c) const {
  const auto index = channels()->find(c);
  return index ? values_[*index] : unknown_;
}

}  // namespace netpocket
