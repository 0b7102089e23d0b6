#include "engine/analysis/metrics/net_flight.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace netpocket {
namespace {

constexpr double kNever = std::numeric_limits<double>::quiet_NaN();

}  // namespace

NetFlight::NetFlight(const ChannelList& channels)
    : area_(channels.find("net_area")),
      part_(channels.find("net_area_part")),
      distance_(channels.find("net_distance")),
      mouth_(channels.find("mouth_area")),
      tension_(channels.find(Channel::rope_tension_max)),
      enclosure_(channels.find("enclosure")),
      captured_(channels.find("captured")),
      tether_(channels.find("tether_tension")),
      drawstring_(channels.find("drawstring_tension")),
      captured_time_(kNever),
      last_enclosure_(kNever) {}

double NetFlight::value(const Snapshot& snapshot, std::optional<std::size_t> channel) const {
  return channel ? snapshot.channels[*channel] : kNever;
}

void NetFlight::add(const Snapshot& snapshot, bool is_touched) {
  if (!area_) return;
  const double interval = is_begun_ ? snapshot.time - last_time_ : 0;
  is_begun_ = true;
  last_time_ = snapshot.time;
  if (!is_touched) {
    follow_area(snapshot);
    if (value(snapshot, part_) >= kOpenPart) open_time_ += interval;
    if (mouth_) largest_mouth_ = std::max(largest_mouth_, snapshot.channels[*mouth_]);
    const double tension = value(snapshot, tension_);
    flight_peak_ = std::max(flight_peak_, tension);
    flight_sum_ += tension;
    ++flight_frames_;
  }
  follow_capture(snapshot, interval);
  follow_tether(snapshot);
  if (drawstring_) drawstring_peak_.add(snapshot.channels[*drawstring_], snapshot.time);
}

void NetFlight::Peak::add(double some, double when) {
  if (some <= value) return;
  value = some;
  time = when;
}

// The largest area of the first opening. A net that hits its target may also be stretched again by the tow.
void NetFlight::follow_area(const Snapshot& snapshot) {
  const double area = value(snapshot, area_);
  is_past_ = is_past_ || (largest_part_ >= kOpenPart && area < kOpeningOver * largest().area);
  if (is_past_ || area <= largest().area) return;
  largest_part_ = value(snapshot, part_);
  rises_.push_back({area, snapshot.time, value(snapshot, distance_)});
}

NetFlight::Place NetFlight::spread() const {
  const double enough = kSpreadPart * largest().area;
  const auto found = std::ranges::find_if(rises_, [enough](const Place& place) { return place.area >= enough; });
  return found == rises_.end() ? Place{0, 0, 0} : *found;
}

void NetFlight::follow_capture(const Snapshot& snapshot, double interval) {
  last_enclosure_ = value(snapshot, enclosure_);
  const bool is_held = value(snapshot, captured_) > 0;
  if (std::isnan(captured_time_)) {
    if (is_held) captured_time_ = snapshot.time;
    return;
  }
  (is_held ? held_time_ : lost_time_) += interval;
}

void NetFlight::follow_tether(const Snapshot& snapshot) {
  if (!tether_) return;
  const double tension = snapshot.channels[*tether_];
  tether_peak_.add(tension, snapshot.time);
  if (tension > 0 && !is_taut_) ++snaps_;
  is_taut_ = tension > 0;
}

void NetFlight::list(std::vector<Metric>& list) const {
  if (!area_) return;
  list.push_back({"net_area_peak", "m^2", "largest area of the net in its first opening, before it touches the target",
                  largest().area});
  list.push_back({"net_area_peak_part", "1", "the same by the flat net's", largest_part_});
  list.push_back({"net_area_time", "s", "when that was", largest().time});
  list.push_back({"net_area_distance", "m", "how far the net had flown then", largest().distance});
  list.push_back({"net_spread_time", "s", "when its area first was 0.95 of that", spread().time});
  list.push_back({"net_spread_distance", "m", "how far it had flown then", spread().distance});
  if (mouth_) {
    list.push_back({"net_mouth_peak", "m^2", "largest area within the net's perimeter before it touches the target",
                    largest_mouth_});
  }
  list.push_back({"net_open_time", "s", "for which the net in flight has 0.8 of its flat area or more", open_time_});
  list.push_back({"flight_tension_peak", "N", "largest tension of a net cord before it touches the target",
                  flight_frames_ > 0 ? flight_peak_ : kNever});
  list.push_back({"flight_tension_snap", "1", "the same by the mean over the frames of the largest one in each",
                  flight_sum_ > 0 ? flight_peak_ * flight_frames_ / flight_sum_ : kNever});
  list.push_back(
      {"enclosure_end", "1", "part of all directions from the target that the net covers at the end", last_enclosure_});
  list.push_back({"captured_time", "s", "when the net first covers more than half of all directions", captured_time_});
  const double since = held_time_ + lost_time_;
  list.push_back(
      {"captured_share", "1", "of the time since then for which it does", since > 0 ? held_time_ / since : kNever});
  if (tether_) {
    list.push_back({"tether_tension_peak", "N", "largest tension of the tether at the spacecraft", tether_peak_.value});
    list.push_back({"tether_tension_peak_time", "s", "when that was", tether_peak_.time});
    list.push_back({"tether_snaps", "1", "frames in which the tether is taut after one in which it was slack",
                    static_cast<double>(snaps_)});
  }
  if (!drawstring_) return;
  list.push_back({"drawstring_tension_peak", "N",
                  "largest tension of the drawstring where it is wound, mean over the sides", drawstring_peak_.value});
  list.push_back({"drawstring_tension_peak_time", "s", "when that was", drawstring_peak_.time});
}

}  // namespace netpocket
