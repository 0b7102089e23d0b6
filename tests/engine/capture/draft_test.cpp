// Drafts: the softened pocket, its step, and what a capture comes to (engine/scenario/fidelity.h).

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <numbers>

#include "engine/analysis/report.h"
#include "engine/analysis/summary.h"
#include "engine/capture/run.h"
#include "engine/capture/simulation.h"
#include "engine/recording/recording.h"
#include "engine/scenario/fidelity.h"
#include "engine/scenario/read_scenario.h"
#include "engine/systems/pocket/pocket.h"
#include "tests/engine/verification_table.h"

namespace netpocket {
namespace {

class VerificationDraft : public test::VerificationTest {
 protected:
  static Scenario capture(Fidelity fidelity) {
    Scenario scenario = read_scenario_file(NETPOCKET_SOURCE_DIR "/scenarios/case1.toml").scenario;
    scenario.target.radius = 3;
    scenario.target.position = {0.5, 8, 0.3};
    scenario.target.velocity = {0.02, 0.2, 0.03};
    scenario.target.inertia = {720, 720, 720};
    scenario.towing.mode = TowingMode::none;
    scenario.output.end_time = 12;
    scenario.output.frame_rate = 20;
    scenario.solver.fidelity = fidelity;
    return scenario;
  }

  // Of a run to its end.
  static std::string record(const Scenario& scenario, RunSummary& summary, RunStatistics& statistics) {
    const auto path = std::filesystem::temp_directory_path() / fmt::format("netpocket_draft_{}.h5", getpid());
    const RunResult result = run_to_recording(scenario, path.string(), {.overwrite = true});
    EXPECT_EQ(result.status.reason, RunReason::finished) << result.status.message;
    const Recording recording(path.string());
    summary = summarize(recording);
    statistics = result.statistics;
    const std::string json = summary_json(recording).value("draft", "");
    EXPECT_EQ(json, recording.origin().draft);
    std::string text = summary_text(recording);
    std::filesystem::remove(path);
    return text;
  }
};

TEST_F(VerificationDraft, SoftensStretchOnly) {
  const Scenario scenario = capture(Fidelity::draft);
  const Model model = build_pocket(scenario).model;
  const double area = std::numbers::pi / 4 * 0.004 * 0.004, second_moment = std::numbers::pi / 64 * std::pow(0.004, 4);
  const CableSection& cord = model.materials[0].section;
  expect_relative("EA of a draft's cords, N", cord.EA, 12e9 * area / 30, 1e-12, "E A/30");
  expect_relative("EI of a draft's cords, N m^2", cord.EI, 12e9 * second_moment, 1e-12, "E I, not softened");
  expect_relative("mass of a draft's cords, kg/m", cord.mass_per_length, 1430 * area, 1e-12, "rho A");
  // A uniform bar on both sides of a kink: A = pi (R^2 - r^2).
  const double inner = 0.05 - 0.0015, of_rod = std::numbers::pi * (0.05 * 0.05 - inner * inner);
  expect_relative("EA of a draft's rods above the kink, N", model.materials[3].section.EA, 0.75e9 * of_rod / 30, 1e-12,
                  "E A/30");
  const double in_full = static_cast<double>(build_pocket(capture(Fidelity::full)).model.elements.size());
  EXPECT_LT(static_cast<double>(model.elements.size()), in_full / 5);
}

TEST_F(VerificationDraft, ComesToTheSameCapture) {
  RunSummary full, draft;
  RunStatistics of_full, of_draft;
  const std::string full_text = record(capture(Fidelity::full), full, of_full);
  const std::string draft_text = record(capture(Fidelity::draft), draft, of_draft);
  EXPECT_EQ(draft.captured, full.captured);
  ASSERT_TRUE(draft.first_contact_time && full.first_contact_time);
  expect_value("first contact of a draft, s", *draft.first_contact_time, *full.first_contact_time, 0.101,
               "the same capture in full, two frames");
  expect_relative("impulse of a draft on the target, N s", draft.impulse.norm(), full.impulse.norm(), 0.15,
                  "the same capture in full; single captures scatter, DRAFT.md has the mean");
  expect_below("steps of a draft by those in full", of_draft.steps / static_cast<double>(of_full.steps), 0.4,
               "a step of bending waves of the rods against one of axial waves");
  EXPECT_EQ(full_text.find("\ndraft "), std::string::npos);
  EXPECT_NE(draft_text.find("\ndraft "), std::string::npos) << draft_text;
  EXPECT_NE(draft_text.find(draft_notice(Fidelity::draft)), std::string::npos);
}

}  // namespace
}  // namespace netpocket
