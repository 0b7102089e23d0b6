// Recordings by version 0.1, which lack the channels that came later.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "engine/analysis/csv.h"
#include "engine/analysis/report.h"
#include "engine/recording/verify.h"
#include "tests/engine/recording/synthetic_run.h"

namespace netpocket {
namespace {

// A coarse capture that was stopped after contact, by netpocket 0.1.0 (ca4457c).
constexpr const char* kOlder = NETPOCKET_SOURCE_DIR "/tests/recordings/version_0_1.h5";

// What came after version 0.1.
constexpr auto kLater = {Channel::penetration_part,      Channel::penetration_element, Channel::penetration_body,
                         Channel::penetration_stiffness, Channel::overlap_part,        Channel::overlap_element,
                         Channel::overlap_other,         Channel::overlap_stiffness,   Channel::energy_contact,
                         Channel::spent_in_cords,        Channel::spent_at_hinges,     Channel::spent_in_contacts,
                         Channel::spent_by_friction,     Channel::contact_step,        Channel::shortened_steps,
                         Channel::limited_hinges,        Channel::loose_hinges,        Channel::stopped_blows,
                         Channel::unresolved_contacts,   Channel::stopped_cords,       Channel::parted_overlaps};

TEST(OlderRecording, OpensWithWhatItHas) {
  const Recording recording(kOlder);
  EXPECT_EQ(recording.origin().netpocket_version, "0.1.0");
  EXPECT_EQ(recording.origin().commit, "ca4457c");
  EXPECT_EQ(recording.status().reason, RunReason::stopped);
  ASSERT_GT(recording.frame_count(), 5u);
  for (std::size_t c = 0; c < kKnownChannelCount; ++c) {
    const auto channel = static_cast<Channel>(c);
    const bool is_later = std::ranges::count(kLater, channel) > 0;
    EXPECT_EQ(recording.has_channel(channel), !is_later) << channel_info(channel).name;
    const auto& values = recording.channel(channel);
    ASSERT_EQ(values.size(), recording.frame_count());
    for (const double value : values) EXPECT_EQ(std::isfinite(value), !is_later) << channel_info(channel).name;
  }
  for (const ChannelInfo& channel : *recording.channels()) {
    EXPECT_EQ(channel, (*known_channels())[*known_channels()->find(channel.name)]) << "kind and meaning are known";
  }
  EXPECT_GT(recording.channel(Channel::energy_dissipated).back(), 0);
  EXPECT_TRUE(std::isnan(recording.frame(1).channel(Channel::spent_by_friction)));
  EXPECT_FALSE(recording.checkpoint(0).state.empty());
}

TEST(OlderRecording, IsSound) {
  const Verification result = verify_recording(kOlder);
  EXPECT_TRUE(result.ok()) << result.problems.front();
  EXPECT_EQ(result.frames, Recording(kOlder).frame_count());
}

// What was not recorded has no column.
TEST(OlderRecording, TableHasTheColumnsItRecorded) {
  const TemporaryFolder folder;
  write_channels_csv(Recording(kOlder), folder.file("channels.csv"));
  const std::string table = read_bytes(folder.file("channels.csv"));
  const std::string header = table.substr(0, table.find('\n'));
  EXPECT_EQ(std::ranges::count(header, ',') + 1, kKnownChannelCount - kLater.size());
  EXPECT_NE(header.find("energy_dissipated,energy_error"), header.npos) << header;
  EXPECT_EQ(table.find("nan"), table.npos);
}

}  // namespace
}  // namespace netpocket
