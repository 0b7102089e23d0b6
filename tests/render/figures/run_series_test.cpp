#include <gtest/gtest.h>

#include <cmath>

#include "engine/recording/recorder.h"
#include "engine/recording/recording.h"
#include "render/figures/plot_figures.h"
#include "test_directory.h"

namespace netpocket {
namespace {

// Three frames whose channel c has the value 100 c + frame.
void record(const std::string& path, const RunOrigin& origin) {
  Recorder recorder(path, origin, Structure{}, false);
  for (int frame = 0; frame < 3; ++frame) {
    Snapshot snapshot;
    snapshot.time = 0.1 * frame;
    for (std::size_t c = 0; c < snapshot.channels.size(); ++c)
      snapshot.channels[c] = 100.0 * static_cast<double>(c) + frame;
    snapshot.channel(Channel::time) = snapshot.time;
    recorder.write(snapshot);
  }
  recorder.finish({RunReason::finished, 0.2, ""}, {});
}

TEST(RunSeries, HasTheChannelsAndPhasesOfTheRecording) {
  const std::filesystem::path directory = test_directory();
  std::filesystem::create_directories(directory);
  const std::string path = (directory / "run.h5").string();
  RunOrigin origin;
  origin.scenario_name = "case2";
  origin.phases = pocket_phases(0, 7.5, std::numeric_limits<double>::quiet_NaN());
  record(path, origin);

  const Recording recording(path);
  const std::vector<RunSeries> runs = run_series({&recording});
  ASSERT_EQ(runs.size(), 1u);
  EXPECT_EQ(runs[0].name, "case2");
  EXPECT_EQ(phase_end(runs[0].phases, kClosing), 7.5);
  EXPECT_TRUE(std::isnan(phase_begin(runs[0].phases, kTowing)));
  ASSERT_EQ(runs[0].times().size(), 3u);
  EXPECT_DOUBLE_EQ(runs[0].times()[2], 0.2);
  const double contact_fy = 100.0 * static_cast<double>(Channel::contact_fy);
  EXPECT_EQ(runs[0].channel(Channel::contact_fy), (std::vector<double>{contact_fy, contact_fy + 1, contact_fy + 2}));
  EXPECT_EQ(plot_figures(runs, directory).size(), 7u);
}

TEST(RunSeries, PhasesThatBeginWithEventsFollowTheFrames) {
  std::vector<ChannelInfo> infos(known_channels()->begin(), known_channels()->end());
  infos.push_back({kPhaseChannel, "1", "phase of the capture"});
  RunSeries series;
  series.begin(std::make_shared<const ChannelList>(infos));
  const auto append = [&](double time, double phase) {
    std::vector<double> values(infos.size(), 0.0);
    values[series.channel_list->find(Channel::time).value()] = time;
    values.back() = phase;
    series.append(values);
  };
  append(0, 0);
  append(1, 0);
  EXPECT_TRUE(std::isnan(phase_begin(series.phases, kClosing)));
  append(2, 1);
  EXPECT_EQ(phase_begin(series.phases, kClosing), 2);
  EXPECT_FALSE(std::isfinite(phase_end(series.phases, kClosing)));
  append(3, 2);
  EXPECT_EQ(phase_end(series.phases, kClosing), 3);
}

}  // namespace
}  // namespace netpocket
