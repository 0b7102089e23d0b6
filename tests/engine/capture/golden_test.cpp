// Short runs give the bits they gave before: in every build of every instruction set, with any number of threads. A
// change of results must be wanted: then NETPOCKET_RENEW=1 writes the hashes anew.

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>

#include "engine/base/fingerprint.h"
#include "engine/capture/simulation.h"
#include "engine/scenario/check_scenario.h"
#include "engine/scenario/read_scenario.h"

namespace netpocket {
namespace {

constexpr const char* kPath = NETPOCKET_SOURCE_DIR "/tests/engine/capture/golden_hashes.txt";

// The scenario states every parameter, so that changed defaults do not matter.
Scenario golden_scenario() {
  ScenarioResult result = read_scenario_file(NETPOCKET_SOURCE_DIR "/tests/engine/capture/golden.toml");
  EXPECT_TRUE(result.ok()) << result.diagnostics.text();
  EXPECT_TRUE(check_scenario(result.scenario).ok()) << check_scenario(result.scenario).text();
  return result.scenario;
}

template <typename Matrix>
void add(Fingerprint& hash, const Matrix& values) {
  hash.add(std::span<const double>(values.data(), static_cast<std::size_t>(values.size())));
}

std::string hash_of_run(const Scenario& scenario, int threads) {
  Simulation simulation(scenario, {threads});
  Fingerprint hash;
  for (double time = 0.1; time < scenario.output.end_time + 0.05; time += 0.1) {
    EXPECT_EQ(simulation.advance(time).reason, RunReason::finished);
    const Snapshot s = simulation.snapshot();
    for (const auto* m : {&s.positions, &s.velocities, &s.gradients}) add(hash, *m);
    add(hash, s.tension);
    for (const BodyState& body : s.bodies) {
      add(hash, body.position);
      add(hash, body.attitude.coeffs());
      add(hash, body.angular_velocity);
    }
    hash.add(s.channels);
  }
  return hash.text();
}

std::map<std::string, std::string> read_hashes() {
  std::map<std::string, std::string> hashes;
  std::ifstream file(kPath);
  for (std::string name, hash; file >> name >> hash;) hashes[name] = hash;
  return hashes;
}

void expect_golden(const std::string& name, const std::string& hash) {
  std::printf("hash %s %s\n", name.c_str(), hash.c_str());  // ./dev determinism compares builds
  auto hashes = read_hashes();
  if (std::getenv("NETPOCKET_RENEW") == nullptr) {
    EXPECT_EQ(hash, hashes[name]) << name << "; if results were to change: NETPOCKET_RENEW=1 ctest -j1 -R Golden";
    return;
  }
  hashes[name] = hash;
  std::ofstream file(kPath);
  for (const auto& [other, value] : hashes) file << other << ' ' << value << '\n';
}

TEST(Golden, MeanStrain) { expect_golden("mean_strain", hash_of_run(golden_scenario(), 1)); }

TEST(Golden, TwoThreads) { EXPECT_EQ(hash_of_run(golden_scenario(), 2), hash_of_run(golden_scenario(), 1)); }

TEST(Golden, FullEvaluation) {
  Scenario scenario = golden_scenario();
  scenario.solver.evaluation = Evaluation::full;
  scenario.output.end_time = 0.2;
  expect_golden("full", hash_of_run(scenario, 1));
}

}  // namespace
}  // namespace netpocket
