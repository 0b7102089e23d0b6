#pragma once
// Measures of a thrown net: how far it opens, where, how its cords snap taut in flight, whether it keeps what it wraps,
// and how its tether and drawstring pull. From the channels of such a run (systems/thrown_net/thrown_net_channels.h);
// other runs have none of them.

#include <limits>
#include <optional>
#include <string_view>
#include <vector>

#include "engine/analysis/metrics/metrics.h"
#include "engine/state/channels.h"

namespace netpocket {

// A net counts as open while its area is at least this part of the flat net's.
inline constexpr double kOpenPart = 0.8;
// The first opening of a net that has been open is over when its area falls below this part of its largest. Nets spring
// back and may open again, by a little more.
inline constexpr double kOpeningOver = 0.95;
// It counts as spread once its area first is this part of the largest: about there the area is flat, and round-off
// decides when it is largest.
inline constexpr double kSpreadPart = 0.95;

class NetFlight {
 public:
  explicit NetFlight(const ChannelList& channels);

  // Snapshots in the order of their times. `is_touched`: whether the net has touched the target by then.
  void add(const Snapshot& snapshot, bool is_touched);
  bool is_of_run() const { return area_.has_value(); }  // whether the run is one of a thrown net
  // Nothing if it is not.
  void list(std::vector<Metric>& list) const;

 private:
  struct Place {
    double area, time, distance;  // m^2, s, m
  };

  // The largest value so far that is above zero, and when it was; NaN: never.
  struct Peak {
    double value = 0;
    double time = std::numeric_limits<double>::quiet_NaN();  // s

    void add(double some, double when);
  };

  double value(const Snapshot& snapshot, std::optional<std::size_t> channel) const;
  Place largest() const { return rises_.empty() ? Place{0, 0, 0} : rises_.back(); }
  Place spread() const;
  void follow_area(const Snapshot& snapshot);
  void follow_capture(const Snapshot& snapshot, double interval);
  void follow_tether(const Snapshot& snapshot);

  std::optional<std::size_t> area_, part_, distance_, mouth_, tension_, enclosure_, captured_, tether_, drawstring_;
  std::vector<Place> rises_;  // frames of the first opening with a larger area than all before
  double last_time_ = 0;
  bool is_begun_ = false, is_past_ = false;
  double largest_part_ = 0, open_time_ = 0;
  double flight_peak_ = 0, flight_sum_ = 0;
  int flight_frames_ = 0;
  double captured_time_, held_time_ = 0, lost_time_ = 0, last_enclosure_;
  double largest_mouth_ = 0;
  Peak tether_peak_, drawstring_peak_;
  int snaps_ = 0;
  bool is_taut_ = false;
};

}  // namespace netpocket
