#pragma once
// Rods and panels of the netted pocket that are not like the others: the table [scatter] of a scenario. Pure functions:
// any thread may call them.

#include <string_view>
#include <vector>

#include "engine/base/diagnostics.h"
#include "engine/scenario/parameters.h"

namespace netpocket {

// The table's group and its parameters.
const ParameterGroup& scatter_group();
std::vector<Parameter> scatter_parameters();

// Factors of a parameter of the table, one for each sector: 1 where the scenario names none. The scenario must pass
// check_scenario.
std::vector<double> sector_factors(const Scenario& scenario, std::string_view key);

inline constexpr std::string_view kRodStiffness = "scatter.rod_stiffness";
inline constexpr std::string_view kRodPressure = "scatter.rod_pressure";
inline constexpr std::string_view kPanelStiffness = "scatter.panel_stiffness";

// Adds what is wrong with the table. Every number must be within its limits.
void check_sector_scatter(const Scenario& scenario, Diagnostics& problems);

}  // namespace netpocket
