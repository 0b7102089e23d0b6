// All metrics of hand-made runs, and of recordings.

#include "engine/analysis/metrics/metrics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>

#include "engine/recording/recording.h"
#include "engine/scenario/scenario.h"
#include "tests/engine/analysis/metrics/hand_made_net.h"
#include "tests/engine/recording/synthetic_run.h"

namespace netpocket {
namespace {

constexpr double kPi = std::numbers::pi;

std::map<std::string, double> by_name(const std::vector<Metric>& metrics) {
  std::map<std::string, double> values;
  for (const Metric& metric : metrics) values[metric.name] = metric.value;
  EXPECT_EQ(values.size(), metrics.size()) << "two metrics with one name";
  return values;
}

// The bag with a target of 0.5 m that rises along its axis, and a spacecraft that moves away at 0.1 m/s.
struct BagCapture {
  HandMadeNet net = hand_made_bag();
  HandMadeNet closed = hand_made_bag(0.5);

  BagCapture() {
    net.structure.bodies = {{"spacecraft", BodyRole::spacecraft, Box{{1, 1, 1}}, 100},
                            {"target", BodyRole::target, Sphere{0.5}, 10}};
    closed.structure = net.structure;
  }

  Snapshot frame(double time, double height, bool is_closed = false) const {
    Snapshot s = (is_closed ? closed : net).snapshot(time);
    s.bodies[0].velocity = {0, -0.1, 0};
    s.bodies[1].position = {0, height, 0};
    s.channel(Channel::closing_length) = is_closed ? 0.5 : 2;
    s.channel(Channel::commanded_length) = is_closed ? 0.45 : 2;
    return s;
  }
};

TEST(Metrics, OfACapture) {
  const BagCapture run;
  MetricOptions options;
  options.closing_end = 2;
  options.strengths = {100, 0, 400};
  MetricsCollector collector(run.net.structure, options);
  Snapshot s = run.frame(0, 3.5);
  s.bodies[1].velocity = {0, -2.1, 0};
  s.bodies[1].angular_velocity = {0, 0.5, 0};
  collector.add(s);
  s = run.frame(1, 2.0);
  s.tension[0] = 50;
  collector.add(s);
  s = run.frame(2, 0.75, true);
  s.channel(Channel::contact_count) = 1;
  s.contacts = {{{0, 0.25, 0}, {0, 30, 40}, 0, 1}};
  s.tension[12] = 100;
  collector.add(s);
  s = run.frame(3, 0.5, true);
  s.bodies[1].velocity = {0, -0.1, 0.4};
  s.channel(Channel::spent_by_friction) = 3;
  s.channel(Channel::energy_dissipated) = 7;
  collector.add(s);

  auto value = by_name(collector.metrics());
  EXPECT_NEAR(value["mouth_area_start"], 4, 1e-14);
  EXPECT_NEAR(value["mouth_area_end"], 0.25, 1e-14);
  // 95 % of the way from 2 to 0.45 m is 0.5275 m.
  EXPECT_EQ(value["closed_time"], 2);
  // At 1 s the sphere's centre is in the plane of the ropes, 1 m from the nearest points of theirs.
  EXPECT_NEAR(value["smallest_gap"], 1 - 0.5 - HandMadeNet::kRadius, 1e-14);
  EXPECT_EQ(value["smallest_gap_time"], 1);
  EXPECT_EQ(value["first_contact_time"], 2);
  EXPECT_NEAR(value["escape_depth"], 2 - 0.75, 1e-14);
  EXPECT_NEAR(value["escape_opening"], 2 * std::sqrt(0.25 / kPi), 1e-14);
  EXPECT_NEAR(value["hull_volume_start"], 8, 1e-12);
  // Frustum of a pyramid: h/3 (A + B + sqrt(A B)).
  EXPECT_NEAR(value["hull_volume_end"], 2.0 / 3 * (4 + 0.25 + 1), 1e-12);
  EXPECT_NEAR(value["relative_speed_start"], 2, 1e-14);
  EXPECT_NEAR(value["relative_speed_end"], 0.4, 1e-14);
  EXPECT_NEAR(value["angular_momentum_start"], 0.4 * 10 * 0.25 * 0.5, 1e-14);
  EXPECT_EQ(value["angular_momentum_end"], 0);
  EXPECT_EQ(value["utilisation_peak"], 0.5);
  EXPECT_EQ(value["load_body"], 50);
  EXPECT_EQ(value["spent_by_friction"], 3);
  EXPECT_EQ(value["energy_dissipated"], 7);
  EXPECT_NEAR(value["modified_opening"], 0.0625, 1e-14);
  EXPECT_EQ(value["modified_outside"], 0);
  // The net is below the sphere, the ropes are above it, and only its top is farther than a mesh from both.
  EXPECT_GT(value["covered_share"], 0.5);
  EXPECT_LT(value["covered_share"], 1);

  ASSERT_EQ(collector.history().time, (std::vector<double>{0, 1, 2, 3}));
  EXPECT_NEAR(collector.history().hull_volume[1], 8, 1e-12);
  EXPECT_NEAR(collector.history().mouth_area[2], 0.25, 1e-14);
}

// Attitude and forces by phases: closing until 2 s, towing from 3 s on.
TEST(Metrics, TellPeaksByPhases) {
  const BagCapture run;
  MetricOptions options;
  options.phases = pocket_phases(0, 2, 3);
  MetricsCollector collector(run.net.structure, options);
  const auto add = [&](double time, double angle, double tension, double force, bool touches) {
    Snapshot s = run.frame(time, 3);
    s.bodies[0].attitude = Eigen::AngleAxisd(0.2 + angle, Eigen::Vector3d(0.6, 0, 0.8));
    s.channel(Channel::closing_tension) = tension;
    s.channel(Channel::contact_fy) = force;
    s.channel(Channel::contact_count) = touches ? 1 : 0;
    collector.add(s);
  };
  add(0, 0, 5, 0, false);
  add(1, -0.3, 9, 0, false);
  add(1.9, 0.01, 4, -70, true);
  add(2.5, -0.02, 50, 40, true);
  add(3, 0.05, 60, -20, true);
  add(4, 0.5, 60, 30, false);
  auto value = by_name(collector.metrics());
  EXPECT_NEAR(value["attitude_peak"], 0.5, 1e-14);
  EXPECT_NEAR(value["impact_attitude"], 0.02, 1e-14);
  EXPECT_EQ(value["closing_tension_peak"], 9);
  EXPECT_EQ(value["closing_tension_end"], 4);
  EXPECT_EQ(value["towing_force_peak"], 20);
  EXPECT_TRUE(std::isnan(value["towing_thrust_peak"]));
}

TEST(Metrics, TakesTheGivenInertia) {
  const BagCapture run;
  MetricOptions options;
  options.target_inertia = Eigen::Vector3d(1, 2, 3).asDiagonal();
  MetricsCollector collector(run.net.structure, options);
  Snapshot s = run.frame(0, 3);
  s.bodies[1].attitude = Eigen::AngleAxisd(kPi / 2, Eigen::Vector3d::UnitZ());  // the body's x is the world's y
  s.bodies[1].angular_velocity = {0, 0.5, 0};
  collector.add(s);
  EXPECT_NEAR(by_name(collector.metrics())["angular_momentum_start"], 0.5, 1e-14);
}

TEST(Metrics, SamplesTheHistoryAtItsInterval) {
  const BagCapture run;
  MetricOptions options;
  options.interval = 0.5;
  MetricsCollector collector(run.net.structure, options);
  for (int i = 0; i <= 10; ++i) collector.add(run.frame(0.1 * i, 3));
  EXPECT_EQ(collector.history().time.size(), 3u);
}

TEST(Metrics, SayNothingAboutWhatDidNotHappen) {
  const BagCapture run;
  MetricsCollector collector(run.net.structure, {});
  collector.add(run.frame(0, 9));
  const auto value = by_name(collector.metrics());
  for (const char* name : {"closed_time", "first_contact_time", "escape_depth", "escape_opening", "utilisation_peak"}) {
    EXPECT_TRUE(std::isnan(value.at(name))) << name;
  }
  EXPECT_EQ(value.at("load_body"), 0);
  EXPECT_EQ(value.at("covered_share"), 0);
}

TEST(Metrics, DoNotTakeMissingContactPointsForNoLoad) {
  const BagCapture run;
  MetricsCollector collector(run.net.structure, {});
  Snapshot s = run.frame(0, 1);
  s.channel(Channel::contact_count) = 3;
  collector.add(s);
  EXPECT_TRUE(std::isnan(by_name(collector.metrics()).at("load_body")));
}

TEST(Metrics, HaveTheSameNamesForAnEmptyRun) {
  const BagCapture run;
  MetricsCollector empty(run.net.structure, {}), full(run.net.structure, {});
  full.add(run.frame(0, 3));
  const auto a = empty.metrics(), b = full.metrics();
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].name, b[i].name);
    EXPECT_FALSE(a[i].unit.empty() || a[i].meaning.empty()) << a[i].name;
  }
  // Neither net nor bodies.
  MetricsCollector nothing(Structure{}, {});
  EXPECT_FALSE(nothing.metrics().empty());
}

TEST(Metrics, OfARecordingAreThoseOfItsFrames) {
  const TemporaryFolder folder;
  const BagCapture run;
  {
    RunOrigin origin;
    origin.phases = pocket_phases(0, 2, 3);
    Recorder recorder(folder.file("run.h5"), origin, run.net.structure, true);
    recorder.write(run.frame(0, 3.5));
    recorder.write(run.frame(2, 0.75, true));
    recorder.write(run.frame(3, 0.5, true));
  }
  const MetricsOfRun found = metrics_of(Recording(folder.file("run.h5")), {});
  auto value = by_name(found.metrics);
  EXPECT_NEAR(value["mouth_area_end"], 0.25, 1e-6);
  EXPECT_NEAR(value["escape_depth"], 1.25, 1e-6);

  const auto json = nlohmann::json::parse(metrics_json(found));
  EXPECT_EQ(json.at("metrics").size(), found.metrics.size());
  EXPECT_EQ(json.at("metrics").at("closed_time").at("value"), 2);
  EXPECT_EQ(json.at("metrics").at("closed_time").at("unit"), "s");
  EXPECT_TRUE(json.at("metrics").at("utilisation_peak").at("value").is_null());
  EXPECT_EQ(json.at("history").at("time").size(), 3u);

  std::istringstream csv(metrics_csv(found.metrics));
  std::string line;
  std::getline(csv, line);
  EXPECT_EQ(line, "name,value,unit,meaning");
  std::size_t lines = 0;
  for (; std::getline(csv, line); ++lines) EXPECT_TRUE(line.starts_with(found.metrics.at(lines).name + ",")) << line;
  EXPECT_EQ(lines, found.metrics.size());
  EXPECT_NE(metrics_text(found.metrics).find("closed_time                        2 s"), std::string::npos)
      << metrics_text(found.metrics);
}

TEST(MetricOptions, OfAPocketComeFromItsScenario) {
  Scenario scenario;
  scenario.net = {.diameter = 0.002, .youngs_modulus = 10e9};
  scenario.target.inertia = {1, 2, 3};
  const BagCapture run;
  const MetricOptions options = metric_options(scenario, run.net.structure);
  EXPECT_NEAR(options.strengths.at(index_of(PocketGroup::net)), 10e9 * kPi * 1e-6 * 0.035, 1e-9);
  EXPECT_EQ(options.strengths.at(index_of(PocketGroup::rods)), 0);
  EXPECT_EQ(options.target_inertia->diagonal(), Eigen::Vector3d(1, 2, 3));
}

}  // namespace
}  // namespace netpocket
