#include "engine/scenario/sector_scatter.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/scenario/system_parameters.h"

namespace netpocket {
namespace {

using Rows = std::vector<Eigen::Vector2d>;

constexpr std::string_view kSource = "user's choice";
constexpr std::string_view kUnits = "1, 1";
constexpr Limits kRowLimits{0, 1000, true};

ParameterValue no_rows() { return Rows(); }

Rows rows_of(const Scenario& scenario, std::string_view key) {
  return std::get<Rows>(find_parameter(key, scenario)->get(scenario));
}

}  // namespace

const ParameterGroup& scatter_group() {
  static const ParameterGroup group{"scatter", "Scatter", "Single rods and panels that are not like the others."};
  return group;
}

std::vector<Parameter> scatter_parameters() {
  return {
      own_parameter(
          kRodStiffness, no_rows, kRowLimits, kUnits,
          "[rod, factor]: rods with another Young's modulus than the others, times this; the kink's joint stays",
          kSource),
      own_parameter(kRodPressure, no_rows, kRowLimits, kUnits,
                    "[rod, factor]: rods with another pressure than rods.pressure, times this, in which they wrinkle",
                    kSource),
      own_parameter(kPanelStiffness, no_rows, kRowLimits, kUnits,
                    "[panel, factor]: panels whose net has another Young's modulus, times this; 0.001: all but torn",
                    kSource),
  };
}

std::vector<double> sector_factors(const Scenario& scenario, std::string_view key) {
  std::vector<double> factors(static_cast<std::size_t>(scenario.pocket.rod_count), 1);
  for (const Eigen::Vector2d& row : rows_of(scenario, key)) {
    factors.at(static_cast<std::size_t>(row.x()) - 1) = row.y();
  }
  return factors;
}

void check_sector_scatter(const Scenario& scenario, Diagnostics& problems) {
  for (const std::string_view key : {kRodStiffness, kRodPressure, kPanelStiffness}) {
    const char* what = key == kPanelStiffness ? "panel" : "rod";
    const auto add = [&](const std::string& message) { problems.add({.key = std::string(key), .message = message}); };
    const Rows rows = rows_of(scenario, key);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const double sector = rows[i].x();
      if (sector != std::trunc(sector) || sector < 1 || sector > scenario.pocket.rod_count) {
        add(fmt::format("row {} names {} {}; the {}s are 1 to {}", i + 1, what, sector, what,
                        scenario.pocket.rod_count));
      } else if (std::ranges::count(rows, sector, [](const auto& row) { return row.x(); }) > 1) {
        add(fmt::format("names {} {} more than once", what, sector));
        break;
      }
    }
    if (key == kRodPressure && !rows.empty() && scenario.rods.pressure == 0) {
      add("needs rods.pressure above 0: without it rods do not wrinkle");
    }
  }
}

}  // namespace netpocket
