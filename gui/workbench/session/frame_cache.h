#pragma once
// Frames in memory, up to a number of bytes: those that were not used for longest go first.
// Thread contract: the user interface's thread.

#include <list>
#include <map>
#include <memory>

#include "engine/state/snapshot.h"
#include "gui/workbench/simulation/worker_messages.h"

namespace netpocket {

// Memory of a frame, bytes.
std::size_t frame_bytes(const Snapshot& snapshot);

class FrameCache {
 public:
  using Frame = std::shared_ptr<const Snapshot>;

  explicit FrameCache(std::size_t capacity) : capacity_(capacity) {}

  void set_capacity(std::size_t bytes);
  std::size_t bytes() const { return bytes_; }

  // Null when it is not in memory.
  Frame find(RunId run, std::size_t index);
  // The same, without counting as a use.
  Frame peek(RunId run, std::size_t index) const;
  void add(RunId run, std::size_t index, Frame frame);
  void forget(RunId run);

 private:
  using Key = std::pair<RunId, std::size_t>;
  struct Entry {
    Frame frame;
    std::list<Key>::iterator use;
  };

  void shrink();

  std::size_t capacity_;
  std::size_t bytes_ = 0;
  std::map<Key, Entry> entries_;
  std::list<Key> uses_;  // the latest first
};

}  // namespace netpocket
