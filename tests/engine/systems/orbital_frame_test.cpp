// Capture systems in an orbit: what rests in the local axes stays, the thrust turns with them, and checks.

#include "engine/systems/orbital_frame.h"

#include <gtest/gtest.h>

#include "engine/capture/simulation.h"
#include "engine/control/towing.h"
#include "engine/orbit/gravity.h"
#include "engine/scenario/check_orbit.h"
#include "engine/scenario/check_scenario.h"
#include "engine/scenario/read_scenario.h"

namespace netpocket {
namespace {

Scenario in_orbit(const std::string& more, const std::string& others = "") {
  const ScenarioResult result = read_scenario_text("system = \"thrown_net\"\n[net]\nside = 4\ncells = 2\n" + others +
                                                       "[target]\nposition = [0, 40, 0]\n[orbit]\n" + more,
                                                   "net.toml");
  EXPECT_TRUE(result.ok()) << result.diagnostics.text();
  return result.scenario;
}

const std::string kAtRest = "[throw]\nspeed = 0\n[tether]\nattached = false\n[towing]\nmode = \"none\"\n";

double channel_of(const Snapshot& snapshot, const char* name) {
  return snapshot.channels[snapshot.channel_list->find(name).value()];
}

// On V-bar nothing drifts: two bodies on the same circle. On R-bar they part by 6 pi per orbit in the end; after a time
// t that is short against it the lower one has gone ahead by n^3 t^3 of the distance, and up by 3/2 n^2 t^2.
TEST(OrbitalFrame, WhatRestsInTheLocalAxesStaysOnVBar) {
  Simulation ahead(in_orbit("model = \"hill\"\naxes = \"local\"\n", kAtRest));
  ahead.advance(30);
  const Snapshot later = ahead.snapshot();
  EXPECT_NEAR(channel_of(later, "target_v_bar"), 40 + 0.5 + 0.5, 1e-4);
  EXPECT_NEAR(channel_of(later, "target_r_bar"), 0, 1e-4);
  EXPECT_NEAR(channel_of(later, "target_h_bar"), 0, 1e-9);
  EXPECT_NE(channel_of(later, "energy_tidal"), 0);
  EXPECT_NEAR(channel_of(later, "energy_error"), 0, 1e-8);

  Simulation below(in_orbit("model = \"two_body\"\naxes = \"local\"\ny_along = \"r_bar\"\n", kAtRest));
  const double apart = channel_of(below.snapshot(), "target_r_bar");
  EXPECT_NEAR(apart, 41, 1);
  below.advance(30);
  const double n = std::sqrt(kEarthMu) * std::pow(kEarthRadius + 400e3, -1.5);
  EXPECT_NEAR(channel_of(below.snapshot(), "target_r_bar") - apart, 1.5 * n * n * 900 * apart, 2e-4);
}

// Fixed axes: the same bodies at rest there turn against the local axes.
TEST(OrbitalFrame, WhatRestsInTheFixedAxesTurnsAgainstTheLocalOnes) {
  Simulation simulation(in_orbit("model = \"hill\"\n", kAtRest));
  simulation.advance(30);
  const double n = std::sqrt(kEarthMu) * std::pow(kEarthRadius + 400e3, -1.5);
  EXPECT_NEAR(channel_of(simulation.snapshot(), "target_r_bar"), -41 * n * 30, 0.001) << "V-bar bends down";
}

TEST(OrbitalFrame, IsOffByDefault) {
  Scenario scenario;
  EXPECT_FALSE(orbit_of(scenario));
  const CaptureSystem system = build_capture_system(scenario);
  EXPECT_FALSE(system.model.orbit);
  EXPECT_FALSE(system.structure.channels->find("energy_tidal"));
}

TEST(OrbitalFrame, ThrustAndHeldAttitudeTurnWithTheLocalAxes) {
  const Scenario scenario = in_orbit("model = \"hill\"\naxes = \"local\"\ny_along = \"r_bar\"\n",
                                     "[towing]\nmode = \"force\"\nsize = 20\nstart = 0\nduration = 10000\n");
  SpacecraftDrive drive(scenario.towing, StationKeeping::attitude, 100);
  drive.follow(*orbit_of(scenario));
  ReferenceOrbit orbit(*orbit_of(scenario));
  const double quarter = 0.5 * 3.14159265358979 / orbit.turning(0).norm();
  const BodyControl control = drive.at(quarter, {});
  EXPECT_LT((control.force + 20 * orbit.local_axes(quarter).col(1)).norm(), 1e-9) << "against R-bar, where that is";
  EXPECT_NEAR(control.force.y(), 0, 1e-6);
  EXPECT_LT((drive.at(quarter + 10, {}).spin - orbit.turning(quarter)).norm(), 1e-12);
}

TEST(OrbitalFrame, ChecksSayWhatDoesNotFit) {
  const auto text = [](const std::string& more, const std::string& others = "") {
    return check_scenario(in_orbit("model = \"hill\"\n" + more, others)).text();
  };
  EXPECT_EQ(text(""), "");
  EXPECT_NE(text("x_along = \"-v_bar\"\n").find("orbit.x_along: must be at a right angle"), std::string::npos);
  EXPECT_NE(text("eccentricity = 0.1\n").find("orbit.eccentricity: must be 0"), std::string::npos);
  EXPECT_NE(text("axes = \"local\"\n", "[towing]\nmode = \"velocity\"\nstart = 1\n").find("towing.mode"),
            std::string::npos);
  EXPECT_NE(text("axes = \"local\"\n", "[spacecraft]\nstation_keeping = \"lateral\"\n").find("station_keeping"),
            std::string::npos);
}

// Steps, threads, checkpoints.
TEST(OrbitalFrame, ARestoredRunGoesOnToTheLastBit) {
  const Scenario scenario = in_orbit("model = \"two_body_j2\"\ninclination = 0.9\naxes = \"local\"\n", "");
  Simulation one(scenario), other(scenario, {.threads = 2});
  one.advance(0.2);
  const auto kept = one.checkpoint();
  other.restore(kept);
  one.advance(0.4);
  other.advance(0.4);
  const Snapshot a = one.snapshot(), b = other.snapshot();
  EXPECT_EQ(a.positions, b.positions);
  EXPECT_EQ(channel_of(a, "energy_tidal"), channel_of(b, "energy_tidal"));
}

}  // namespace
}  // namespace netpocket
