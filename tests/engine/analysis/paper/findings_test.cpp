// Each finding on made-up runs: it holds for a run that behaves as the paper says, and fails when that one thing is
// different.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>

#include "engine/analysis/report.h"
#include "engine/analysis/summary.h"
#include "engine/state/pocket_groups.h"
#include "tests/engine/recording/synthetic_run.h"

namespace netpocket {
namespace {

constexpr double kTowingStart = 10;
constexpr double kEnd = 20;
constexpr double kInterval = 0.1;
constexpr Channel kContactChannels[] = {Channel::contact_fx, Channel::contact_fy, Channel::contact_fz,
                                        Channel::contact_count};

// One rod from (0, 0) over the kink at 8 m to the tip at 12 m, and a cord at the height of the kink.
enum Element : std::int32_t { kMouth, kKinkRow, kCone };

Structure one_rod() {
  Structure structure;
  structure.node_count = 4;
  structure.threads = {"rod 1"};
  structure.elements = {{{1, 2}, {0, 0}}, {{1, 3}, {0, 0}}, {{0, 1}, {0, 0}}};
  structure.gradient_count = 1;
  structure.bodies = {{"spacecraft", BodyRole::spacecraft, Box{{1, 1, 1}}, 1210},
                      {"target", BodyRole::target, Sphere{4}, 200}};
  structure.element_groups = pocket_groups();
  structure.node_groups = {
      {kRodRoots, NodeLook::adapter, {0}}, {kRodKinks, NodeLook::joint, {1}}, {kRodTips, NodeLook::reel, {2}}};
  return structure;
}

// Where the force on the target acts at this moment.
void touch(Snapshot& s, Element element, double fy) {
  s.contacts.push_back({Eigen::Vector3d(0, element == kCone ? 3 : 11, 0), Eigen::Vector3d(0, fy, 0), element, 1});
}

// The paper's story for a closing that ends at `closed`.
Snapshot story(double t, double closed) {
  Snapshot s;
  s.time = t;
  s.positions = s.velocities = Eigen::Matrix3Xd::Zero(3, 4);
  s.positions.row(1) << 0, 8, 12, 8;
  s.gradients = Eigen::Matrix3Xd::Zero(3, 1);
  s.tension = s.strain = Eigen::VectorXd::Zero(3);
  s.bodies.resize(2);
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
  if (fy != 0) touch(s, fy < 0 ? kMouth : kCone, fy);
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

struct StoryOptions {
  double end = kEnd;
  int draws = 1;        // for each closing time
  double spread = 0.1;  // of F_y from draw to draw
  RunReason reason = RunReason::finished;
};

class StoryRuns {
 public:
  explicit StoryRuns(const Change& change = {}, const StoryOptions& options = {}) {
    for (const double closed : {10.0, 7.5, 5.0}) {
      for (int draw = 0; draw < options.draws; ++draw) {
        const std::string path = folder_.file(std::to_string(recordings_.size()) + ".h5");
        const Change draw_it = [&](Snapshot& s, double closing) {
          s.channel(Channel::contact_fy) *= 1 + options.spread * draw;
          if (change) change(s, closing);
        };
        record(path, closed, draw_it, options);
        recordings_.push_back(std::make_unique<Recording>(path));
      }
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
    return {"", "no such finding"};
  }
  const Recording& first() const { return *recordings_.front(); }

 private:
  static void record(const std::string& path, double closed, const Change& change, const StoryOptions& options) {
    RunOrigin origin;
    origin.scenario_name = "closing in " + std::to_string(static_cast<int>(closed)) + " s";
    origin.phases = pocket_phases(0, closed, kTowingStart);
    Recorder recorder(path, origin, one_rod(), false);
    for (int i = 0; i * kInterval <= options.end + 1e-9; ++i) {
      Snapshot snapshot = story(i * kInterval, closed);
      change(snapshot, closed);
      recorder.write(snapshot);
    }
    recorder.finish({options.reason, options.end, ""}, {});
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
    // F3 takes more than one draw: below.
    const Verdict expected = finding.id == "F3" ? Verdict::undecided : Verdict::yes;
    for (const FindingCase& c : finding.cases) EXPECT_EQ(c.verdict, expected) << finding.id << " " << c.value;
  }
  EXPECT_EQ(summarize(runs.first()).captured, Verdict::yes);
}

struct Departure {
  const char* name;
  const char* finding;
  Change change;
};

void PrintTo(const Departure& departure, std::ostream* out) { *out << departure.name; }

Change scale_third_push(double factor) {
  return [factor](Snapshot& s, double closed) {
    if (s.time > 0.81 * closed && s.time <= closed) s.channel(Channel::contact_fy) *= factor;
  };
}

Change move_contacts(Element from, Element to) {
  return [from, to](Snapshot& s, double) {
    for (ContactPoint& point : s.contacts) {
      if (point.element == from) point.element = to;
    }
  };
}

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
      {"ContactAtTheSameTime", "F4", set(Channel::contact_count, 1, 1.1, 1)},
      {"LateralForceBeforeClosed", "F5", set(Channel::contact_fx, 4, 4.1, 5)},
      {"NoForceInX", "F5", scale(Channel::contact_fx, 0)},
      {"NoForceInZ", "F5", scale(Channel::contact_fz, 0)},
      {"LateralForceDependsOnClosing", "F5",
       [](Snapshot& s, double closed) { s.channel(Channel::contact_fx) *= closed < 6 ? 2.5 : 1; }},
      {"ForcesInTheOtherOrder", "F6", scale(Channel::contact_fy, -1)},
      {"NoThirdEpisode", "F6", scale_third_push(0)},
      {"ThirdPushBelowAQuarter", "F6", scale_third_push(0.25)},
      {"PushDownByTheKinkRow", "F6", move_contacts(kMouth, kKinkRow)},
      {"PushDownByTheCone", "F6", move_contacts(kMouth, kCone)},
      {"PushUpByTheMouth", "F6", move_contacts(kCone, kMouth)},
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
  EXPECT_EQ(found.verdict, Verdict::no) << found.value;
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
  EXPECT_TRUE(found.holds()) << found.value;
}

// Impacts shorter than an interval leave no point at its ends: the nearest frames within 0.1 s tell, no others.
TEST(Findings, PushesBetweenFramesAreThoseOfTheNextPoints) {
  const Change every_third = [](Snapshot& s, double) {
    if (std::lround(s.time / kInterval) % 3 != 0) s.contacts.clear();
  };
  const FindingCase found = StoryRuns(every_third).found("F6");
  EXPECT_EQ(found.verdict, Verdict::yes) << found.value;
  EXPECT_EQ(found.value.find("unknown"), std::string::npos) << found.value;
  const Change one_in_ten = [](Snapshot& s, double) {
    if (std::lround(s.time / kInterval) % 10 != 1) s.contacts.clear();
  };
  EXPECT_NE(StoryRuns(one_in_ten).found("F6").value.find("unknown"), std::string::npos);
}

// The impulse of an interval is divided by the forces that point its way at both its ends.
TEST(Findings, PushesAreDividedByWhereForcesAct) {
  const Change a_third_by_the_cone = [](Snapshot& s, double) {
    for (ContactPoint& point : s.contacts) point.force.y() *= 2;
    if (!s.contacts.empty() && s.contacts.front().element == kMouth) {
      touch(s, kCone, s.contacts.front().force.y() / 2);
      touch(s, kCone, -s.contacts.front().force.y());
    }
  };
  // The mouth pulls down with 2, the cone down with 1 and up with 2: in all up with 1, which the impulse does not
  // follow.
  const FindingCase opposed = StoryRuns(a_third_by_the_cone).found("F6");
  EXPECT_NE(opposed.value.find("(100 % mouth, 0 % kink row, 0 % cone; y = "), std::string::npos) << opposed.value;
  const Change half_by_the_cone = [](Snapshot& s, double) {
    if (!s.contacts.empty() && s.contacts.front().element == kMouth) touch(s, kCone, s.contacts.front().force.y());
  };
  const FindingCase halved = StoryRuns(half_by_the_cone).found("F6");
  EXPECT_NE(halved.value.find("(50 % mouth, 0 % kink row, 50 % cone; y = 7 m)"), std::string::npos) << halved.value;
  EXPECT_EQ(halved.verdict, Verdict::no);
}

TEST(Findings, WithoutContactPointsTheOrderOfForcesIsNotKnown) {
  const FindingCase none = StoryRuns([](Snapshot& s, double) { s.contacts.clear(); }).found("F6");
  EXPECT_EQ(none.verdict, Verdict::unknown);
  EXPECT_EQ(none.value, "the recording has no contact points");
  // Points at the first touch only: what follows is not assigned.
  const FindingCase few = StoryRuns([](Snapshot& s, double) {
                            if (s.time > 5.15) s.contacts.clear();
                          }).found("F6");
  EXPECT_EQ(few.verdict, Verdict::unknown);
  EXPECT_NE(few.value.find("100 % unknown"), std::string::npos) << few.value;
}

TEST(Findings, SayWhatARunLacks) {
  const StoryRuns cut({}, {.end = 9});
  EXPECT_EQ(cut.found("F2").value, "run ends at t = 9 s, before the closing is over at 10 s");
  EXPECT_EQ(cut.found("F8").value, "run ends at t = 9 s, before the first second of towing is over at 11 s");
  for (const char* id : {"F2", "F3", "F4", "F5", "F6", "F7", "F8", "F9", "F10", "F11"}) {
    EXPECT_EQ(cut.found(id).verdict, Verdict::unknown) << id;
  }
  EXPECT_EQ(summarize(cut.first()).captured, Verdict::unknown);
  const StoryRuns untouched([](Snapshot& s, double) {
    for (const Channel c : kContactChannels) s.channel(c) = 0;
  });
  for (const char* id : {"F1", "F2", "F3", "F4", "F5", "F6", "F7", "F8"}) {
    EXPECT_EQ(untouched.found(id).verdict, Verdict::no) << id;
  }
}

TEST(Findings, OfOneRunCompareNothing) {
  const StoryRuns runs;
  const auto findings = evaluate_findings({&runs.first()});
  EXPECT_EQ(findings[2].cases.at(0).verdict, Verdict::undecided);
  EXPECT_EQ(findings[2].cases.at(0).value, "closing ends at 10 s: peak |F_y| 40 N; one draw decides nothing");
  for (const std::size_t i : {3u, 4u}) EXPECT_EQ(findings[i].cases.at(0).verdict, Verdict::unknown);
  EXPECT_TRUE(findings[0].cases.at(0).holds());
}

TEST(Findings, OfADivergedRunSaySo) {
  const StoryRuns runs({}, {.reason = RunReason::diverged});
  for (const Finding& finding : runs.findings()) {
    for (const FindingCase& c : finding.cases) {
      EXPECT_EQ(c.verdict, Verdict::diverged) << finding.id;
      EXPECT_EQ(c.value, "the run diverged at t = 20 s");
    }
  }
  EXPECT_EQ(summarize(runs.first()).captured, Verdict::diverged);
  const auto summary = summary_json(runs.first());
  EXPECT_TRUE(summary["captured"].is_null());
  EXPECT_EQ(summary["capture"], "diverged");
  EXPECT_NE(summary_text(runs.first()).find("captured       diverged: the run diverged at t = 20 s\n"),
            std::string::npos);
  const auto json = findings_json(runs.findings());
  EXPECT_TRUE(json["findings"][0]["cases"][0]["holds"].is_null());
  EXPECT_EQ(json["findings"][0]["cases"][0]["verdict"], "diverged");
}

// One diverged run among several leaves what compares them without a verdict.
TEST(Findings, ADivergedRunIsComparedWithNothing) {
  const StoryRuns good;
  const StoryRuns bad({}, {.reason = RunReason::diverged});
  const auto findings = evaluate_findings({&good.first(), &bad.first()});
  for (const std::size_t i : {2u, 3u, 4u}) {
    EXPECT_EQ(findings[i].cases.at(0).verdict, Verdict::unknown) << findings[i].id;
    EXPECT_EQ(findings[i].cases.at(1).verdict, Verdict::diverged) << findings[i].id;
  }
}

TEST(Findings, DrawsDecideWhetherFasterIsHarder) {
  const StoryRuns clear({}, {.draws = 3, .spread = 0.05});
  EXPECT_EQ(clear.found("F3").verdict, Verdict::yes) << clear.found("F3").value;
  EXPECT_NE(clear.found("F3").value.find("3 draws from 40 to 44"), std::string::npos) << clear.found("F3").value;
  const StoryRuns wide({}, {.draws = 3, .spread = 1});
  EXPECT_EQ(wide.found("F3").verdict, Verdict::undecided) << wide.found("F3").value;
  const StoryRuns reversed([](Snapshot& s, double closed) { s.channel(Channel::contact_fy) *= closed * closed; },
                           {.draws = 3});
  EXPECT_EQ(reversed.found("F3").verdict, Verdict::no) << reversed.found("F3").value;
  const StoryRuns same({}, {.draws = 3, .spread = 0});
  EXPECT_EQ(same.found("F3").verdict, Verdict::undecided) << "three times the same draw is one";
  EXPECT_NE(same.found("F3").value.find("one draw decides nothing"), std::string::npos) << same.found("F3").value;
}

TEST(Findings, AsJsonAndText) {
  const StoryRuns runs;
  const auto json = findings_json(runs.findings());
  ASSERT_EQ(json["findings"].size(), 11u);
  EXPECT_EQ(json["findings"][0]["id"], "F1");
  EXPECT_EQ(json["findings"][3]["cases"][2]["name"], "closing in 5 s");
  EXPECT_EQ(json["findings"][3]["cases"][2]["holds"], true);
  EXPECT_EQ(json["findings"][3]["cases"][2]["verdict"], "yes");
  EXPECT_EQ(json["findings"][3]["cases"][2]["measures"][0].dump(),
            R"({"name":"first contact","unit":"s","value":2.6})");
  const std::string text = findings_text(runs.findings());
  EXPECT_NE(text.find("F4   Faster closing gives an earlier first contact.\n"
                      "       closing in 10 s  yes        closing ends at 10 s: first contact at 5.1 s\n"),
            std::string::npos)
      << text;
}

}  // namespace
}  // namespace netpocket
