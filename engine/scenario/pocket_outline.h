#pragma once
// The outline of the open pocket: where the rods stand and the panels between them, before any mesh.

#include <Eigen/Core>
#include <array>
#include <vector>

#include "engine/scenario/scenario.h"

namespace netpocket {

// A point of rod `rod` at distance r from the axis and height y (m), in the world frame: rod k stands in the direction
// (cos(a), 0, sin(a)), a = 2 pi k/rod_count.
Eigen::Vector3d rod_point(const PocketParameters& pocket, int rod, const Eigen::Vector2d& radius_height);

// Distance between adjacent rod tips of the open pocket, m: the rope length at which closing starts.
double open_tip_distance(const Scenario& scenario);

// The flat quadrilateral between two adjacent rods, over one segment of their profile.
struct PanelOutline {
  std::array<Eigen::Vector3d, 2> lower;  // m, on rod k and on rod k + 1
  std::array<Eigen::Vector3d, 2> upper;  // m, on rod k and on rod k + 1

  // u = 0..1 from rod k to rod k + 1, v = 0..1 upwards.
  Eigen::Vector3d point(double u, double v) const {
    return (1 - v) * ((1 - u) * lower[0] + u * lower[1]) + v * ((1 - u) * upper[0] + u * upper[1]);
  }
};

// All panels, the lower part of each before its upper part.
std::vector<PanelOutline> panel_outlines(const Scenario& scenario);

// Elements that the pocket's mesh will have at most; as a double because it may be very large.
double largest_element_count(const Scenario& scenario);

}  // namespace netpocket
