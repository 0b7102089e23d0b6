#pragma once
// What the figures need of a run: its channels over time. Filled from a recording, a live run or a test.

#include <memory>
#include <string>
#include <vector>

#include "engine/state/channels.h"
#include "engine/state/control_loop_info.h"
#include "engine/state/phase.h"

namespace netpocket {

class Recording;

struct RunSeries {
  std::string name;  // shown in titles and legends
  std::shared_ptr<const ChannelList> channel_list = known_channels();
  std::vector<std::vector<double>> channels =
      std::vector<std::vector<double>>(channel_list->size());  // by channel_list
  std::vector<Phase> phases;
  std::vector<ControlLoopInfo> loops;
  std::string draft{};  // RunOrigin::draft: what is said of a draft; empty otherwise

  // By frame; empty where the run has no such channel.
  const std::vector<double>& channel(Channel c) const;
  // To be filled: throws std::bad_optional_access where the run has no such channel.
  std::vector<double>& channel(Channel c) { return channels[channel_list->find(c).value()]; }
  const std::vector<double>& times() const { return channel(Channel::time); }
  // Has these channels from now on, and no frame.
  void begin(std::shared_ptr<const ChannelList> list);
  // One more frame, by channel_list.
  void append(const std::vector<double>& values);
};

// Throws RecordingError when the recording cannot be read.
RunSeries run_series(const Recording& recording);
// Named as run_labels() does.
std::vector<RunSeries> run_series(const std::vector<const Recording*>& recordings);

}  // namespace netpocket
