// Measures of a thrown net from the channels of made-up frames.

#include "engine/analysis/metrics/net_flight.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace netpocket {
namespace {

const auto kChannels =
    std::make_shared<const ChannelList>(std::vector<ChannelInfo>{{"time", "s", ""},
                                                                 {"net_area", "m^2", ""},
                                                                 {"net_area_part", "1", ""},
                                                                 {"net_distance", "m", ""},
                                                                 channel_info(Channel::rope_tension_max),
                                                                 {"enclosure", "1", ""},
                                                                 {"captured", "1", ""},
                                                                 {"tether_tension", "N", ""},
                                                                 {"mouth_area", "m^2", ""},
                                                                 {"drawstring_tension", "N", ""}});

Snapshot frame(double time, double part, double tension, double enclosure, double tether) {
  Snapshot snapshot;
  snapshot.time = time;
  snapshot.channel_list = kChannels;
  snapshot.channels = {time,   100 * part, part,      2 * time, tension, enclosure, enclosure > 0.5 ? 1.0 : 0.0,
                       tether, 40 * part,  4 * tether};
  return snapshot;
}

std::map<std::string, double> measures(const NetFlight& flight) {
  std::vector<Metric> list;
  flight.list(list);
  std::map<std::string, double> values;
  for (const Metric& metric : list) values[metric.name] = metric.value;
  return values;
}

TEST(NetFlight, MeasuresFlightCaptureAndTether) {
  NetFlight flight(*kChannels);
  flight.add(frame(0, 0.1, 0, 0.1, 0), false);
  flight.add(frame(1, 0.86, 2, 0.2, 0), false);
  flight.add(frame(2, 0.9, 10, 0.3, 5), false);
  flight.add(frame(3, 0.7, 4, 0.3, 3), false);
  flight.add(frame(3.5, 0.92, 4, 0.3, 3), false);  // springs back
  flight.add(frame(4, 0.95, 50, 0.6, 0), true);    // the tow stretches it
  flight.add(frame(6, 0.5, 50, 0.4, 9), true);
  flight.add(frame(7, 0.5, 50, 0.7, 2), true);
  auto value = measures(flight);
  EXPECT_EQ(value["net_area_peak"], 90);
  EXPECT_EQ(value["net_area_peak_part"], 0.9);
  EXPECT_EQ(value["net_area_time"], 2);
  EXPECT_EQ(value["net_area_distance"], 4);
  EXPECT_EQ(value["net_spread_time"], 1);  // 86 m^2 are more than 0.95 of 90
  EXPECT_EQ(value["net_spread_distance"], 2);
  EXPECT_EQ(value["net_open_time"], 2.5);
  EXPECT_EQ(value["flight_tension_peak"], 10);
  EXPECT_EQ(value["flight_tension_snap"], 2.5);  // the mean of 0, 2, 10, 4 and 4 is 4
  EXPECT_EQ(value["enclosure_end"], 0.7);
  EXPECT_EQ(value["captured_time"], 4);
  EXPECT_DOUBLE_EQ(value["captured_share"], 1.0 / 3);
  EXPECT_EQ(value["tether_tension_peak"], 9);
  EXPECT_EQ(value["tether_tension_peak_time"], 6);
  EXPECT_EQ(value["tether_snaps"], 2);
  EXPECT_EQ(value["net_mouth_peak"], 40 * 0.92);  // before the tow
  EXPECT_EQ(value["drawstring_tension_peak"], 36);
  EXPECT_EQ(value["drawstring_tension_peak_time"], 6);
}

TEST(NetFlight, OfAnotherSystemHasNothingToSay) {
  NetFlight flight(*known_channels());
  EXPECT_FALSE(flight.is_of_run());
  EXPECT_TRUE(measures(flight).empty());
}

TEST(NetFlight, SlackLinesHaveNoTimeOfTheirPeak) {
  NetFlight flight(*kChannels);
  flight.add(frame(0, 0.1, 0, 0.1, 0), false);
  auto value = measures(flight);
  EXPECT_EQ(value["tether_tension_peak"], 0);
  EXPECT_TRUE(std::isnan(value["tether_tension_peak_time"]));
  EXPECT_TRUE(std::isnan(value["drawstring_tension_peak_time"]));
}

TEST(NetFlight, WithoutCaptureDoesNotKnowWhen) {
  NetFlight flight(*kChannels);
  flight.add(frame(0, 0.1, 0, 0.1, 0), false);
  EXPECT_TRUE(std::isnan(measures(flight)["captured_time"]));
  EXPECT_TRUE(std::isnan(measures(flight)["captured_share"]));
}

}  // namespace
}  // namespace netpocket
