#include "gui/workbench/session/frame_cache.h"

namespace netpocket {

std::size_t frame_bytes(const Snapshot& snapshot) {
  const auto numbers = snapshot.positions.size() + snapshot.velocities.size() + snapshot.gradients.size() +
                       snapshot.tension.size() + snapshot.strain.size();
  return sizeof(Snapshot) + static_cast<std::size_t>(numbers) * sizeof(double) +
         snapshot.contacts.size() * sizeof(ContactPoint) + snapshot.bodies.size() * sizeof(BodyState);
}

void FrameCache::set_capacity(std::size_t bytes) {
  capacity_ = bytes;
  shrink();
}

FrameCache::Frame FrameCache::find(RunId run, std::size_t index) {
  const auto entry = entries_.find({run, index});
  if (entry == entries_.end()) return nullptr;
  uses_.splice(uses_.begin(), uses_, entry->second.use);
  return entry->second.frame;
}

FrameCache::Frame FrameCache::peek(RunId run, std::size_t index) const {
  const auto entry = entries_.find({run, index});
  return entry == entries_.end() ? nullptr : entry->second.frame;
}

void FrameCache::add(RunId run, std::size_t index, Frame frame) {
  const Key key{run, index};
  if (find(run, index)) return;
  bytes_ += frame_bytes(*frame);
  uses_.push_front(key);
  entries_[key] = {std::move(frame), uses_.begin()};
  shrink();
}

void FrameCache::forget(RunId run) {
  for (auto entry = entries_.lower_bound({run, 0}); entry != entries_.end() && entry->first.first == run;) {
    bytes_ -= frame_bytes(*entry->second.frame);
    uses_.erase(entry->second.use);
    entry = entries_.erase(entry);
  }
}

void FrameCache::shrink() {
  // The frame used last stays, whatever its size.
  while (bytes_ > capacity_ && uses_.size() > 1) {
    const auto entry = entries_.find(uses_.back());
    bytes_ -= frame_bytes(*entry->second.frame);
    entries_.erase(entry);
    uses_.pop_back();
  }
}

}  // namespace netpocket
