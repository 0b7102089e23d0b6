// channels.csv, the summary and their JSON.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "engine/analysis/csv.h"
#include "engine/analysis/report.h"
#include "engine/analysis/summary.h"
#include "engine/state/written_time.h"
#include "tests/engine/recording/synthetic_run.h"

namespace netpocket {
namespace {

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, separator);) parts.push_back(part);
  return parts;
}

TEST(Csv, HoldsEveryChannelExactly) {
  const TemporaryFolder folder;
  write_synthetic_run(folder.file("run.h5"), 12);
  const Recording recording(folder.file("run.h5"));
  const std::string path = folder.file("channels.csv");
  write_bytes(path, "an older one");
  write_channels_csv(recording, path);
  const auto lines = split(read_bytes(path), '\n');
  ASSERT_EQ(lines.size(), 13u);
  const auto names = split(lines[0], ',');
  ASSERT_EQ(names.size(), known_channels()->size());
  EXPECT_EQ(names.front(), "time");
  for (std::size_t i = 0; i < 12; ++i) {
    const auto values = split(lines[i + 1], ',');
    ASSERT_EQ(values.size(), names.size());
    for (std::size_t c = 0; c < names.size(); ++c) {
      EXPECT_EQ(names[c], (*known_channels())[c].name);
      const double recorded = recording.channel(static_cast<Channel>(c))[i];
      EXPECT_EQ(std::stod(values[c]), c == 0 ? written_time(recorded) : recorded);
    }
  }
  EXPECT_FALSE(std::filesystem::exists(path + ".part"));
}

// Times are sums of steps.
TEST(Csv, WritesTheFramesTimes) {
  EXPECT_EQ(written_time(2.999999999999357), 3);
  EXPECT_EQ(written_time(0.06 + 3e-13), 0.06);
  EXPECT_EQ(written_time(1.99987), 1.99987);  // a step short of 2 s
  const TemporaryFolder folder;
  const Structure structure = synthetic_structure(4);
  {
    Recorder recorder(folder.file("run.h5"), synthetic_origin(), structure, true);
    Snapshot frame = synthetic_frame(structure, 0);
    frame.time = 2.999999999999357;
    recorder.write(frame);
  }
  write_channels_csv(Recording(folder.file("run.h5")), folder.file("channels.csv"));
  EXPECT_TRUE(split(read_bytes(folder.file("channels.csv")), '\n').at(1).starts_with("3,"));
}

TEST(Csv, SaysWhyItCannotWrite) {
  const TemporaryFolder folder;
  write_synthetic_run(folder.file("run.h5"), 1);
  const Recording recording(folder.file("run.h5"));
  const std::string path = folder.file("missing/channels.csv");
  try {
    write_channels_csv(recording, path);
    FAIL();
  } catch (const FileError& error) {
    EXPECT_EQ(error.what(), "cannot write \"" + path + "\": No such file or directory");
  }
}

// Three frames at 0, 0.5 and 1 s with forces, the numbers below by hand.
void write_three_frames(const std::string& path, const std::string& name = "case1") {
  Structure structure;
  structure.node_count = 1;
  RunOrigin origin;
  origin.scenario_name = name;
  Recorder recorder(path, origin, structure, true);
  Snapshot s;
  s.positions = s.velocities = Eigen::Matrix3Xd::Zero(3, 1);
  s.gradients.resize(3, 0);
  s.channel(Channel::energy_kinetic) = 3;
  recorder.write(s);
  s.time = 0.5;
  s.channel(Channel::contact_fx) = 1;
  s.channel(Channel::contact_fy) = -8;
  s.channel(Channel::contact_fz) = 2;
  s.channel(Channel::energy_input) = 5;
  s.channel(Channel::energy_error) = -0.04;
  recorder.write(s);
  s.time = 1;
  s.channel(Channel::contact_fx) = -4;
  s.channel(Channel::contact_fy) = 6;
  s.channel(Channel::energy_input) = 1;
  s.channel(Channel::energy_error) = 0.02;
  recorder.write(s);
}

TEST(Summary, ComputesPeaksImpulsesAndEnergyError) {
  const TemporaryFolder folder;
  write_three_frames(folder.file("run.h5"));
  const RunSummary summary = summarize(Recording(folder.file("run.h5")));
  EXPECT_EQ(summary.first_contact_time, 0.5);
  EXPECT_EQ(summary.peak_force, Eigen::Vector3d(-4, -8, 2));
  EXPECT_EQ(summary.peak_time_y, 0.5);
  EXPECT_EQ(summary.impulse, Eigen::Vector3d(-1.5, -1, 2));
  EXPECT_DOUBLE_EQ(summary.energy_error, 0.04 / (5 + 3));
  EXPECT_EQ(summary.averaging_window, 0.5);
  EXPECT_EQ(summary.captured, Verdict::unknown);
}

TEST(Summary, HasTheDocumentedKeys) {
  const TemporaryFolder folder;
  write_three_frames(folder.file("run.h5"));
  const auto json = summary_json(Recording(folder.file("run.h5")));
  for (const char* key : {"scenario", "version", "simulated_seconds", "wall_seconds", "cpu_seconds", "elements",
                          "steps", "captured", "first_contact_time", "energy_error"}) {
    EXPECT_TRUE(json.contains(key)) << key;
  }
  EXPECT_EQ(json["peak_force"].dump(), R"({"x":-4.0,"y":-8.0,"z":2.0,"time_y":0.5})");
  EXPECT_EQ(json["impulse"].dump(), R"({"x":-1.5,"y":-1.0,"z":2.0})");
  EXPECT_EQ(json["simulated_seconds"], 1.0);
}

TEST(Summary, SurvivesTextThatIsNotUtf8) {
  const TemporaryFolder folder;
  write_three_frames(folder.file("run.h5"), "caf\xe9");
  EXPECT_EQ(summary_json(Recording(folder.file("run.h5")))["scenario"], "caf\xef\xbf\xbd");
}

TEST(Summary, ReadsAsATable) {
  const TemporaryFolder folder;
  write_three_frames(folder.file("run.h5"));
  const std::string text = summary_text(Recording(folder.file("run.h5")));
  EXPECT_NE(text.find("peak force               -4          -8           2  N, y at t = 0.5 s"), std::string::npos)
      << text;
  EXPECT_NE(text.find("energy error   0.04 J, 0.5 % of the energy put in"), std::string::npos) << text;
}

}  // namespace
}  // namespace netpocket
