// Rods and panels that are not like the others.

#include "engine/systems/pocket/sector_variation.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/capture/simulation.h"
#include "engine/scenario/check_scenario.h"
#include "engine/scenario/read_scenario.h"
#include "engine/scenario/sector_scatter.h"
#include "engine/scenario/write_scenario.h"
#include "engine/state/pocket_groups.h"

namespace netpocket {
namespace {

Scenario with(const std::string& table) {
  Scenario scenario;
  scenario.pocket.mesh_columns = scenario.pocket.mesh_rows = 2;
  scenario.pocket.elements_per_side = 1;
  scenario.rods.pressure = 20e3;
  scenario.output.end_time = 1;
  ScenarioResult read = read_scenario_text(write_scenario_text(scenario), "base");
  const auto at = write_scenario_text(scenario).find("[scatter]");
  EXPECT_NE(at, std::string::npos);
  read = read_scenario_text(write_scenario_text(scenario).substr(0, at) + "[scatter]\n" + table, "scattered");
  EXPECT_TRUE(read.ok()) << read.diagnostics.text();
  return read.scenario;
}

bool belongs_to(const Pocket& pocket, const ModelElement& element, const std::string& thread) {
  return pocket.model.threads[static_cast<std::size_t>(element.thread)].starts_with(thread);
}

TEST(SectorVariation, MaterialsAreThoseOfTheirRodAndPanel) {
  const Scenario scenario =
      with("rod_stiffness = [[3, 0.5], [8, 1.2]]\nrod_pressure = [[3, 0.25]]\npanel_stiffness = [[1, 0.01]]\n");
  ASSERT_TRUE(check_scenario(scenario).ok()) << check_scenario(scenario).text();
  const Pocket scattered = build_pocket(scenario), even = build_pocket(with(""));
  ASSERT_EQ(scattered.model.elements.size(), even.model.elements.size());
  int rods = 0, cords = 0;
  for (std::size_t i = 0; i < even.model.elements.size(); ++i) {
    const ModelElement& element = scattered.model.elements[i];
    const bool is_third = belongs_to(scattered, element, "rod 3"), is_eighth = belongs_to(scattered, element, "rod 8"),
               is_panel = belongs_to(scattered, element, "panel 1 ");
    const double stiffness = is_third ? 0.5 : is_eighth ? 1.2 : is_panel ? 0.01 : 1;
    const auto index = static_cast<std::int32_t>(i);
    const CableMaterial &now = scattered.model.material_of(index), &before = even.model.material_of(index);
    EXPECT_DOUBLE_EQ(now.section.EA, stiffness * before.section.EA);
    EXPECT_DOUBLE_EQ(now.section.EI, stiffness * before.section.EI);
    EXPECT_EQ(now.section.mass_per_length, before.section.mass_per_length);
    if (std::isfinite(before.wrinkling_moment)) {
      EXPECT_DOUBLE_EQ(now.wrinkling_moment, (is_third ? 0.25 : 1) * before.wrinkling_moment);
    }
    rods += is_third || is_eighth ? 1 : 0;
    cords += is_panel ? 1 : 0;
  }
  EXPECT_EQ(rods, 2 * 4);
  EXPECT_GT(cords, 8);
  EXPECT_EQ(even.model.materials.size(), 4u);
  EXPECT_EQ(scattered.model.materials.size(), 4u + 2 + 2 + 1);
  EXPECT_EQ(scattered.rod_materials.size(), 2u + 4);
}

// The closing ropes pull all tips alike: a rod of half the stiffness gives way further.
TEST(SectorVariation, AWeakRodBendsFurther) {
  const auto radius_of_tips = [](const Scenario& scenario) {
    Simulation simulation(scenario);
    simulation.advance(1);
    const Snapshot snapshot = simulation.snapshot();
    std::vector<double> radii;
    for (const std::int32_t tip : simulation.structure().nodes(kRodTips)) {
      radii.push_back(std::hypot(snapshot.positions(0, tip), snapshot.positions(2, tip)));
    }
    return radii;
  };
  Scenario scenario = with("rod_stiffness = [[3, 0.2]]\n");
  scenario.closing.duration = 1;
  scenario.target.position.y() = 40;
  const auto radii = radius_of_tips(scenario);
  for (std::size_t rod = 0; rod < radii.size(); ++rod) {
    if (rod == 2) continue;
    EXPECT_LT(radii[2], radii[rod] - 0.01) << "rod " << rod + 1;
  }
}

TEST(SectorVariation, SaysWhatIsWrong) {
  const auto problem = [](const std::string& table) { return check_scenario(with(table)).text(); };
  EXPECT_EQ(problem(""), "");
  EXPECT_NE(problem("rod_stiffness = [[9, 1.1]]").find("row 1 names rod 9; the rods are 1 to 8"), std::string::npos);
  EXPECT_NE(problem("rod_stiffness = [[2, 1.1], [2, 1.2]]").find("names rod 2 more than once"), std::string::npos);
  EXPECT_NE(problem("panel_stiffness = [[1.5, 1.1]]").find("the panels are 1 to 8"), std::string::npos);
  Scenario plain = with("rod_pressure = [[1, 0.5]]");
  plain.rods.pressure = 0;
  EXPECT_NE(check_scenario(plain).text().find("needs rods.pressure above 0"), std::string::npos);
}

}  // namespace
}  // namespace netpocket
