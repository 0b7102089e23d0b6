// Each finding on made-up runs: it holds for a run that behaves as the paper says, and fails when that one thing is
// different.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>

#include "engine/recording/report.h"
#include "engine/recording/summary.h"
#include "tests/engine/recording/synthetic_run.h"

namespace netpocket {
namespace {

constexpr double kTowingStart = 10;
constexpr double kEnd = 20;
constexpr double kInterval = 0.1;
constexpr Channel kContactChannels[] = {Channel::contact_fx, Channel::contact_fy, Channel::contact_fz,
                                        Channel::contact_count};

// The paper's story for a closing that ends at `closed`.
Snapshot story(double t, double closed) {
  Snapshot s;
  s.time = t;
  s.positions = s.velocities = Eigen::Matrix3Xd::Zero(3, 1);
  s.gradients.resize(3, 0);
  const double phase = t / closed;
  const auto within = [phase](double from, double to) { return phase > from && phase <= to; };
  const double force = 400 / closed;
  const bool towing = t > kTowingStart;
  double fy = 0;
  if (within(0.5, 0.6)) fy = -force;
  if (within(0.65, 0.8)) fy = 0.8 * force;
  if (within(0.85, 1.0)) fy = -0.7 * force;
  if (towing) fy = -0.2 * force;
  const double moved = within(0.5, 1.0) ? 0.03 * std::sin(20 * phase) : 0;
  const double towed = towing ? -0.005 * std::pow(t - kTowingStart, 2) : 0;
  const double sway = towing ? std::sin(t - kTowingStart) : 0;
  s.channel(Channel::contact_fy) = fy;
  s.channel(Channel::contact_fx) = towing ? 3 : 0;
  s.channel(Channel::contact_fz) = towing ? -2 : 0;
  s.channel(Channel::contact_count) = fy != 0 ? 4 : 0;
  s.channel(Channel::target_x) = 1e-3 * sway;
  s.channel(Channel::target_y) = 7.5 + moved + towed;
  s.channel(Channel::spacecraft_x) = 1e-5 * sway;
  s.channel(Channel::spacecraft_y) = -1 - moved / 2 + towed;
  s.channel(Channel::target_inside) = 1;
  s.channel(Channel::commanded_length) = phase < 1 ? 5.78 - 3.68 * phase : 2.1;
  s.channel(Channel::closing_length) = s.channel(Channel::commanded_length) * 1.001;
  return s;
}

using Change = std::function<void(Snapshot&, double closed)>;

class StoryRuns {
 public:
  explicit StoryRuns(const Change& change = {}, double end = kEnd) {
    for (const double closed : {10.0, 7.5, 5.0}) {
      const std::string path = folder_.file(std::to_string(recordings_.size()) + ".h5");
      record(path, closed, change, end);
      recordings_.push_back(std::make_unique<Recording>(path));
    }
  }

  std::vector<Finding> findings() const {
    std::vector<const Recording*> all;
    for (const auto& recording : recordings_) all.push_back(recording.get());
    return evaluate_findings(all);
  }
  // Of the first case.
  FindingCase found(const std::string& id) const {
    for (const Finding& finding : findings()) {
      if (finding.id == id) return finding.cases.front();
    }
    return {"", "no such finding", false};
  }
  const Recording& first() const { return *recordings_.front(); }

 private:
  static void record(const std::string& path, double closed, const Change& change, double end) {
    Structure structure;
    structure.node_count = 1;
    RunOrigin origin;
    origin.scenario_name = "closing in " + std::to_string(static_cast<int>(closed)) + " s";
    origin.closing_end = closed;
    origin.towing_start = kTowingStart;
    Recorder recorder(path, origin, structure, false);
    for (int i = 0; i * kInterval <= end + 1e-9; ++i) {
      Snapshot snapshot = story(i * kInterval, closed);
      if (change) change(snapshot, closed);
      recorder.write(snapshot);
    }
  }

  TemporaryFolder folder_;
  std::vector<std::unique_ptr<Recording>> recordings_;
};

TEST(Findings, HoldForThePapersStory) {
  const StoryRuns runs;
  const auto findings = runs.findings();
  ASSERT_EQ(findings.size(), 11u);
  for (const Finding& finding : findings) {
    EXPECT_FALSE(finding.text.empty());
    EXPECT_FALSE(finding.rule.empty());
    ASSERT_EQ(finding.cases.size(), 3u);
    for (const FindingCase& c : finding.cases) EXPECT_TRUE(c.holds) << finding.id << " " << c.name << ": " << c.value;
  }
  EXPECT_TRUE(summarize(runs.first()).captured);
}

struct Departure {
  const char* name;
  const char* finding;
  Change change;
};

void PrintTo(const Departure& departure, std::ostream* out) { *out << departure.name; }

std::vector<Departure> departures() {
  const auto set = [](Channel c, double from, double to, double value) {
    return [=](Snapshot& s, double) {
      if (s.time > from + 1e-6 && s.time <= to + 1e-6) s.channel(c) = value;
    };
  };
  const auto scale = [](Channel c, double factor) { return [=](Snapshot& s, double) { s.channel(c) *= factor; }; };
  return {
      {"LateralForceIsLargest", "F1", set(Channel::contact_fz, 12, 12.1, -90)},
      {"LargestForceInTowing", "F2", set(Channel::contact_fy, 12, 12.1, -500)},
      {"ForceFallsWithSpeed", "F3",
       [](Snapshot& s, double closed) { s.channel(Channel::contact_fy) *= closed * closed; }},
      {"ContactAtTheSameTime", "F4", set(Channel::contact_count, 1, 1.1, 1)},
      {"LateralForceBeforeClosed", "F5", set(Channel::contact_fx, 4, 4.1, 5)},
      {"NoForceInX", "F5", scale(Channel::contact_fx, 0)},
      {"NoForceInZ", "F5", scale(Channel::contact_fz, 0)},
      {"LateralForceDependsOnClosing", "F5",
       [](Snapshot& s, double closed) { s.channel(Channel::contact_fx) *= closed < 6 ? 2.5 : 1; }},
      {"ForcesInTheOtherOrder", "F6", scale(Channel::contact_fy, -1)},
      {"NoThirdEpisode", "F6",
       [](Snapshot& s, double closed) {
         if (s.time > 0.8 * closed && s.time <= closed) s.channel(Channel::contact_fy) = 0;
       }},
      {"TargetMovesBeforeContact", "F7", set(Channel::target_y, 1, 2, 7.502)},
      {"SpacecraftMovesBeforeContact", "F7", set(Channel::spacecraft_y, 1, 2, -1.02)},
      {"TargetMovesFar", "F7", set(Channel::target_y, 6, 6.1, 7.65)},
      {"SpacecraftMovesLessThanBeforeContact", "F7",
       [](Snapshot& s, double) {
         if (s.time > 1 && s.time <= 10) s.channel(Channel::spacecraft_y) = s.time < 7 ? -1.005 : -1.006;
       }},
      {"NothingMoves", "F7", set(Channel::spacecraft_y, 0, 10, -1)},
      {"TowingForcesStayLarge", "F8", set(Channel::contact_fy, 12, 12.1, 25)},
      {"ContactLostInTowing", "F8",
       [](Snapshot& s, double) {
         if (s.time < 12) return;
         for (const Channel c : kContactChannels) s.channel(c) = 0;
       }},
      {"TargetStaysBehind", "F9", set(Channel::target_y, 10, 20, 7.5)},
      {"LateralMotionIsLarge", "F10", scale(Channel::target_x, 30)},
      {"LateralMotionIsNone", "F10", scale(Channel::target_x, 0)},
      {"SpacecraftMovesLikeTheTarget", "F10", scale(Channel::spacecraft_x, 17)},
      {"TargetLeaves", "F11", set(Channel::target_inside, 15, 15.1, 0)},
      {"MouthOpensAgain", "F11", set(Channel::closing_length, 15, 15.1, 3)},
  };
}

class FindingsFail : public testing::TestWithParam<Departure> {};

TEST_P(FindingsFail, WhenTheRunDeparts) {
  const FindingCase found = StoryRuns(GetParam().change).found(GetParam().finding);
  EXPECT_FALSE(found.holds) << found.value;
}

INSTANTIATE_TEST_SUITE_P(Each, FindingsFail, testing::ValuesIn(departures()),
                         [](const auto& test) { return std::string(test.param.name); });

// Contacts chatter: short episodes of the other sign and gaps do not change the order.
TEST(Findings, EpisodesIgnoreChatter) {
  const Change chatter = [](Snapshot& s, double) {
    if (std::abs(s.time - 5.5) < 0.01) s.channel(Channel::contact_fy) = 0.1;
    if (std::abs(s.time - 7.0) < 0.01) s.channel(Channel::contact_fy) = 0;
    if (std::abs(s.time - 7.2) < 0.01) s.channel(Channel::contact_fy) = -0.5;
  };
  const FindingCase found = StoryRuns(chatter).found("F6");
  EXPECT_TRUE(found.holds) << found.value;
}

TEST(Findings, SayWhatARunLacks) {
  const StoryRuns cut({}, 9);
  EXPECT_EQ(cut.found("F2").value, "run ends at t = 9 s, before the closing is over at 10 s");
  EXPECT_EQ(cut.found("F8").value, "run ends at t = 9 s, before the first second of towing is over at 11 s");
  for (const char* id : {"F2", "F3", "F4", "F5", "F6", "F7", "F8", "F9", "F10", "F11"}) {
    EXPECT_FALSE(cut.found(id).holds) << id;
  }
  const StoryRuns untouched([](Snapshot& s, double) {
    for (const Channel c : kContactChannels) s.channel(c) = 0;
  });
  for (const char* id : {"F1", "F2", "F3", "F4", "F5", "F6", "F7", "F8"}) EXPECT_FALSE(untouched.found(id).holds) << id;
}

TEST(Findings, OfOneRunCompareNothing) {
  const StoryRuns runs;
  const auto findings = evaluate_findings({&runs.first()});
  for (const std::size_t i : {2u, 3u, 4u}) EXPECT_FALSE(findings[i].cases.at(0).holds) << findings[i].id;
  EXPECT_TRUE(findings[0].cases.at(0).holds);
}

TEST(Findings, AsJsonAndText) {
  const StoryRuns runs;
  const auto json = findings_json(runs.findings());
  ASSERT_EQ(json["findings"].size(), 11u);
  EXPECT_EQ(json["findings"][0]["id"], "F1");
  EXPECT_EQ(json["findings"][3]["cases"][2]["name"], "closing in 5 s");
  EXPECT_EQ(json["findings"][3]["cases"][2]["holds"], true);
  const std::string text = findings_text(runs.findings());
  EXPECT_NE(text.find("F4   Faster closing gives an earlier first contact.\n"
                      "       closing in 10 s  yes  closing ends at 10 s: first contact at 5.1 s\n"),
            std::string::npos)
      << text;
}

}  // namespace
}  // namespace netpocket
