// What a draft is, and what the program says about it (engine/scenario/fidelity.h).

#include "engine/scenario/fidelity.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "engine/scenario/check_scenario.h"
#include "engine/scenario/draft_bias.h"
#include "engine/scenario/parameters.h"
#include "engine/scenario/pocket_outline.h"

namespace netpocket {
namespace {

Scenario draft_of(Scenario scenario = {}) {
  scenario.solver.fidelity = Fidelity::draft;
  return scenario;
}

TEST(Fidelity, FullIsAsTheScenarioSays) {
  Scenario scenario;
  scenario.pocket.mesh_columns = 7;
  scenario.pocket.mesh_rows = 2;
  scenario.pocket.elements_per_side = 4;
  scenario.rods.elements_per_side = 0;
  const MeshDivision mesh = mesh_division(scenario);
  EXPECT_EQ(mesh.columns, 7);
  EXPECT_EQ(mesh.rows, 2);
  EXPECT_EQ(mesh.per_side, 4);
  EXPECT_EQ(mesh.per_side_of_a_rod, 4);
  EXPECT_EQ(axial_softening(scenario), 1);
  EXPECT_EQ(draft_notice(scenario.solver.fidelity), "");
}

TEST(Fidelity, ADraftHasFewMeshesAndOneElementASide) {
  Scenario scenario;
  scenario.pocket.mesh_columns = 7;
  scenario.pocket.mesh_rows = 2;
  const MeshDivision mesh = mesh_division(draft_of(scenario));
  EXPECT_EQ(mesh.columns, 3);
  EXPECT_EQ(mesh.rows, 2);
  EXPECT_EQ(mesh.per_side, 1);
  EXPECT_EQ(mesh.per_side_of_a_rod, 1);
  EXPECT_LT(largest_element_count(draft_of(scenario)), largest_element_count(scenario) / 3);
}

TEST(Fidelity, ADraftSaysItsSofteningAndItsBias) {
  const std::string notice = draft_notice(Fidelity::draft);
  for (const std::string& part :
       {fmt::format("divided by {:g}", kDraftSoftening), fmt::format("over {} scattered captures", kDraftBias.captures),
        fmt::format("{:+.1f} +- {:.1f} percentage points", 100 * kDraftBias.probability.mean,
                    100 * kDraftBias.probability.half_width)}) {
    EXPECT_NE(notice.find(part), std::string::npos) << part << " is not in: " << notice;
  }
  const Parameter* parameter = find_parameter("solver.fidelity");
  ASSERT_NE(parameter, nullptr);
  EXPECT_NE(parameter->help.find(fmt::format("divided by {:g}", kDraftSoftening)), std::string_view::npos);
}

TEST(Fidelity, ThrownNetsAndTheFullEvaluationHaveNoDraft) {
  Scenario full = draft_of();
  EXPECT_TRUE(check_scenario(full).ok());
  full.solver.evaluation = Evaluation::full;
  EXPECT_NE(check_scenario(full).text().find("mean_strain"), std::string::npos);
  Scenario thrown = draft_of();
  thrown.system = "thrown_net";
  EXPECT_NE(check_scenario(thrown).text().find("pocket"), std::string::npos);
}

}  // namespace
}  // namespace netpocket
