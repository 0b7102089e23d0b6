// How deep contacts went and which safeguards acted, in words and as JSON.
#include "engine/recording/soundness.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "engine/analysis/report.h"
#include "tests/engine/recording/synthetic_run.h"

namespace netpocket {
namespace {

using Change = std::function<void(Snapshot&)>;

// Three frames without contact, at 0, 0.02 and 0.04 s, of which `change` alters the second.
Recording recording_with(const TemporaryFolder& folder, const Change& change) {
  const Structure structure = synthetic_structure(6);
  {
    Recorder recorder(folder.file("run.h5"), synthetic_origin(), structure, true);
    for (int i = 0; i < 3; ++i) {
      Snapshot frame = synthetic_frame(structure, i);
      std::ranges::fill(frame.channels, 0.0);
      frame.channel(Channel::contact_step) = 12.34e-6;
      if (i == 1) change(frame);
      recorder.write(frame);
    }
  }
  return Recording(folder.file("run.h5"));
}

TEST(Soundness, SaysHowDeepAndWhy) {
  const TemporaryFolder folder;
  const Recording pressed = recording_with(folder, [](Snapshot& frame) {
    frame.channel(Channel::penetration_part) = 0.9;
    frame.channel(Channel::penetration_element) = 3;
    frame.channel(Channel::penetration_body) = 1;
    frame.channel(Channel::penetration_stiffness) = 0.031;
    frame.channel(Channel::overlap_part) = 0.2;
    frame.channel(Channel::overlap_element) = 0;
    frame.channel(Channel::overlap_other) = 5;
    frame.channel(Channel::overlap_stiffness) = 1;
  });
  EXPECT_EQ(penetration_text(pressed),
            "0.9 of the cord's radius at most (1.8 mm), at t = 0.02 s: panel 1 row 1 (element 3) in the target; its "
            "spring is 32 times softer than the materials, the stiffest that steps of 12.3 µs resolve");
  EXPECT_EQ(overlap_text(pressed),
            "0.2 of the two radii at most (0.8 mm), at t = 0.02 s: rod 1 (element 0) and panel 1 row 1 (element 5); "
            "its spring is as stiff as the materials");
  const nlohmann::json info = summary_json(pressed);
  EXPECT_EQ(info.at("penetration").at("part"), 0.9);
  EXPECT_NEAR(info.at("penetration").at("depth").get<double>(), 1.8e-3, 1e-15);
  EXPECT_EQ(info.at("penetration").at("stiffness"), 0.031);
  EXPECT_EQ(info.at("overlap").at("partner"), "panel 1 row 1 (element 5)");
}

TEST(Soundness, SaysThatThereWasNone) {
  const TemporaryFolder folder;
  const Recording free = recording_with(folder, [](Snapshot&) {});
  EXPECT_EQ(penetration_text(free), "none");
  EXPECT_EQ(overlap_text(free), "none");
  EXPECT_EQ(safeguards_text(free), "none acted");
  EXPECT_TRUE(summary_json(free).at("penetration").is_null());
}

// Counts are those of the last frame.
TEST(Soundness, NamesTheSafeguardsThatActed) {
  const TemporaryFolder folder;
  const Structure structure = synthetic_structure(6);
  {
    Recorder recorder(folder.file("run.h5"), synthetic_origin(), structure, true);
    Snapshot frame = synthetic_frame(structure, 0);
    std::ranges::fill(frame.channels, 0.0);
    frame.channel(Channel::stopped_blows) = 2;
    recorder.write(frame);
    frame.channel(Channel::stopped_blows) = 3;
    frame.channel(Channel::shortened_steps) = 1234567;
    recorder.write(frame);
  }
  const Recording recording(folder.file("run.h5"));
  EXPECT_EQ(safeguards_text(recording),
            "steps shortened 1234567, blows on bodies stopped 3 (each place in each step counts)");
  EXPECT_EQ(summary_json(recording).at("safeguards").at("stopped_blows"), 3);
  EXPECT_EQ(summary_json(recording).at("safeguards").size(), 7u);
}

// By themselves such counts would alarm: every hinge that folds counts in each step.
TEST(Soundness, TellsHowManyHingesAStepWereHeldBack) {
  const TemporaryFolder folder;
  const Structure structure = synthetic_structure(6);
  {
    Recorder recorder(folder.file("run.h5"), synthetic_origin(), structure, true);
    Snapshot frame = synthetic_frame(structure, 0);
    std::ranges::fill(frame.channels, 0.0);
    frame.channel(Channel::limited_hinges) = 104000;
    recorder.write(frame);
    RunStatistics statistics;
    statistics.steps = 83200;
    recorder.finish({RunReason::finished, frame.time, {}}, statistics);
  }
  EXPECT_EQ(safeguards_text(Recording(folder.file("run.h5"))),
            "hinge dampers limited 104000 (1.2 a step on the mean, usual while rods fold: they are damped less) "
            "(each place in each step counts)");
}

// A file may hold any number.
TEST(Soundness, IndicesThatAreNoneAreNotFollowed) {
  const TemporaryFolder folder;
  for (const double index : {-1.0, 6.0, 1e300, -1e300}) {
    const Recording damaged = recording_with(folder, [&](Snapshot& frame) {
      frame.channel(Channel::penetration_part) = frame.channel(Channel::overlap_part) = 0.5;
      frame.channel(Channel::penetration_element) = frame.channel(Channel::overlap_other) = index;
      frame.channel(Channel::penetration_max) = 1e-3;
    });
    EXPECT_EQ(penetration_text(damaged), "1 mm at most, at t = 0.02 s; where was not recorded");
    EXPECT_EQ(overlap_text(damaged), "none");
  }
}

TEST(Soundness, OlderRecordingsDoNotKnow) {
  const Recording older(NETPOCKET_SOURCE_DIR "/tests/recordings/version_0_1.h5");
  EXPECT_NE(penetration_text(older).find("mm at most"), std::string::npos) << penetration_text(older);
  EXPECT_NE(penetration_text(older).find("where was not recorded"), std::string::npos) << penetration_text(older);
  EXPECT_EQ(overlap_text(older), "not recorded");
  EXPECT_EQ(safeguards_text(older), "not recorded");
  EXPECT_TRUE(summary_json(older).at("safeguards").is_null());
}

}  // namespace
}  // namespace netpocket
