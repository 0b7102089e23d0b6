#pragma once
// What the channels of one frame say about a control loop.

#include <QString>
#include <optional>
#include <vector>

#include "engine/state/channels.h"
#include "engine/state/control_loop_info.h"

namespace netpocket {

struct LoopReading {
  // Empty: the loop has no such quantity, or there is no frame.
  std::optional<LoopState> state;
  std::vector<double> set_point, actual, error, commanded, delivered, disturbance;
  std::optional<double> load;
  QString unit, effort_unit;

  bool is_saturated() const;
};

// `values`: of a frame, by `channels`; empty: no frame.
LoopReading read_loop(const ControlLoopInfo& loop, const ChannelList& channels, const std::vector<double>& values);

QString state_words(LoopState state);
// A number with few digits; small ones count as 0 when `largest` is a thousand times larger.
QString short_number(double value, double largest = 0);
double size_of(const std::vector<double>& vector);

}  // namespace netpocket
