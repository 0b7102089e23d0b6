// What of a thrown net converges in mesh and step: the largest area and where it is reached do, the largest tension of
// its tether does not.

#include <fmt/format.h>

#include <cstdlib>

#include "engine/capture/simulation.h"
#include "engine/scenario/read_scenario.h"
#include "tests/engine/verification_table.h"

namespace netpocket {
namespace {

// A net of 8 m that meets nothing, on a tether of 12 m.
struct FreeThrow {
  double area = 0, distance = 0;    // the largest part of the net's own area, and the way flown until then, m
  double tension = 0, impulse = 0;  // of the tether: largest, N; until 14 s, N s

  FreeThrow(int elements_per_side, double safety) {
    const std::string text = fmt::format(
        "system = \"thrown_net\"\n[net]\nside = 8\ncells = 8\nelements_per_side = {}\n[tether]\nlength = 12\n"
        "elements = {}\n[target]\nposition = [0, 300, 0]\n[contact]\ncords = false\n[towing]\nmode = \"none\"\n"
        "[solver]\nsafety = {}\n",
        elements_per_side, 12 * elements_per_side, safety);
    Simulation simulation(read_scenario_text(text, "net.toml").scenario);
    constexpr double kFrame = 0.005;
    for (int frame = 1; frame <= 2800; ++frame) {
      EXPECT_EQ(simulation.advance(frame * kFrame).reason, RunReason::finished);
      const Snapshot snapshot = simulation.snapshot();
      const auto value = [&](const char* name) { return snapshot.channels[snapshot.channel_list->find(name).value()]; };
      if (value("net_area_part") > area) {
        area = value("net_area_part");
        distance = value("net_distance");
      }
      tension = std::max(tension, value("tether_tension"));
      impulse += kFrame * value("tether_tension");
    }
  }
};

class VerificationThrownNetStudy : public test::VerificationTest {};

// A recorded study, not a check: the bounds only keep it from being empty. Run with NETPOCKET_STUDY=1.
TEST_F(VerificationThrownNetStudy, ConvergenceInMeshAndStep) {
  if (std::getenv("NETPOCKET_STUDY") == nullptr) GTEST_SKIP() << "set NETPOCKET_STUDY=1 (and NETPOCKET_RENEW=1)";
  const char* source = "net of 8 m on a tether of 12 m; recorded, see THEORY.md section 12";
  for (const auto& [elements, safety] : {std::pair(1, 0.9), {1, 0.45}, {1, 0.225}, {2, 0.9}, {2, 0.45}, {4, 0.9}}) {
    const FreeThrow run(elements, safety);
    const std::string name = fmt::format("{} elements a mesh side, safety {}: ", elements, safety);
    expect_below(name + "largest area / own area", run.area, 1, source);
    expect_below(name + "distance there, m", run.distance, 12, source);
    expect_below(name + "largest tension of the tether, N", run.tension, 2000, source);
    expect_below(name + "impulse of the tether, N s", run.impulse, 50, source);
  }
}

}  // namespace
}  // namespace netpocket
