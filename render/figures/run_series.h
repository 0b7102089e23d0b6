#pragma once
// What the figures need of a run: its channels over time. Filled from a recording, a live run or a test.

#include <array>
#include <limits>
#include <string>
#include <vector>

#include "engine/recording/channels.h"

namespace netpocket {

class Recording;

struct RunSeries {
  std::string name;                                                // shown in titles and legends
  std::array<std::vector<double>, kChannelCount> channels;         // by Channel; all as long as the times
  double closing_end = std::numeric_limits<double>::quiet_NaN();   // s; NaN when unknown
  double towing_start = std::numeric_limits<double>::quiet_NaN();  // s; NaN when unknown or never

  const std::vector<double>& channel(Channel c) const { return channels[static_cast<std::size_t>(c)]; }
  std::vector<double>& channel(Channel c) { return channels[static_cast<std::size_t>(c)]; }
  const std::vector<double>& times() const { return channel(Channel::time); }
};

// Throws RecordingError when the recording cannot be read.
RunSeries run_series(const Recording& recording);
// Named as run_labels() does.
std::vector<RunSeries> run_series(const std::vector<const Recording*>& recordings);

}  // namespace netpocket
