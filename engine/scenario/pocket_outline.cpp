#include "engine/scenario/pocket_outline.h"

#include <cmath>
#include <numbers>

#include "engine/math/elementary.h"
#include "engine/scenario/fidelity.h"

namespace netpocket {

Eigen::Vector3d rod_point(const PocketParameters& pocket, int rod, const Eigen::Vector2d& radius_height) {
  const double angle = 2 * std::numbers::pi * rod / pocket.rod_count;
  return {radius_height.x() * cosine(angle), radius_height.y(), radius_height.x() * sine(angle)};
}

double open_tip_distance(const Scenario& scenario) {
  return 2 * scenario.rods.profile.back().x() * sine(std::numbers::pi / scenario.pocket.rod_count);
}

std::vector<PanelOutline> panel_outlines(const Scenario& scenario) {
  std::vector<PanelOutline> panels;
  const auto& profile = scenario.rods.profile;
  for (int rod = 0; rod < scenario.pocket.rod_count; ++rod) {
    const auto at = [&](int side, std::size_t i) { return rod_point(scenario.pocket, rod + side, profile[i]); };
    for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
      panels.push_back({.lower = {at(0, i), at(1, i)}, .upper = {at(0, i + 1), at(1, i + 1)}});
    }
  }
  return panels;
}

double largest_element_count(const Scenario& scenario) {
  const PocketParameters& pocket = scenario.pocket;
  const MeshDivision mesh = mesh_division(scenario);
  const double columns = mesh.columns;
  const double rows = mesh.rows;
  const double square_sides = (rows + 1) * columns + rows * (columns + 1);
  const double triangle_sides = 3 * columns * (columns + 1) / 2;
  const double rod_sides = rows + columns;
  const double net = (square_sides + triangle_sides) * mesh.per_side;
  return pocket.rod_count * (net + rod_sides * mesh.per_side_of_a_rod + scenario.closing.elements);
}

}  // namespace netpocket
