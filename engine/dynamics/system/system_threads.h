#pragma once
// Threads that share the loops of one system. Internal to this room.

#include <cstddef>
#include <memory>

#include "engine/base/divided_loop.h"
#include "engine/base/thread_team.h"

namespace netpocket {

class SystemThreads {
 public:
  // `threads`: at most this many. A small system uses one, since a second one would cost more time than it saves.
  SystemThreads(std::size_t elements, int threads)
      : team_(elements < kFewestElements || threads < 2 ? nullptr : std::make_unique<ThreadTeam>(threads)),
        count_(team_ ? threads : 1) {}

  int count() const { return count_; }
  // Valid as long as this object.
  DividedLoop loop() const {
    if (!team_) return undivided_loop;
    return [team = team_.get()](int count, int grain, const auto& work) { team->run(count, grain, work); };
  }
  // A loop over [0, count). `meanwhile` runs on the caller's thread before that thread joins the loop.
  template <typename Work, typename Meanwhile>
  void run(int count, const Work& work, const Meanwhile& meanwhile) const {
    if (team_) {
      team_->run(count, 1, work, meanwhile);
    } else {
      meanwhile();
      work(0, count);
    }
  }
  // Processor time (s) of the threads that help the caller's thread.
  double helpers_cpu_seconds() const { return team_ ? team_->members_cpu_seconds() : 0; }

 private:
  static constexpr std::size_t kFewestElements = 8000;

  std::unique_ptr<ThreadTeam> team_;  // null: one thread
  int count_;
};

}  // namespace netpocket
