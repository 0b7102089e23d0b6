#pragma once
// Outline of the open pocket: rods and panels, without a mesh.

#include <Eigen/Core>
#include <array>
#include <vector>

#include "engine/scenario/scenario.h"

namespace netpocket {

// Point of rod `rod` at distance r from the axis and height y (m), in the world frame. Rod k is in the direction
// (cos(a), 0, sin(a)) from the axis, with a = 2 pi k/rod_count.
Eigen::Vector3d rod_point(const PocketParameters& pocket, int rod, const Eigen::Vector2d& radius_height);

// Distance (m) between adjacent rod tips of the open pocket: the rope length at which closing starts.
double open_tip_distance(const Scenario& scenario);

// Flat quadrilateral between two adjacent rods, over one segment of their profile.
struct PanelOutline {
  std::array<Eigen::Vector3d, 2> lower;  // m, on rod k and on rod k + 1
  std::array<Eigen::Vector3d, 2> upper;  // m, on rod k and on rod k + 1

  // u = 0..1 from rod k to rod k + 1, v = 0..1 upwards. Result in m.
  Eigen::Vector3d point(double u, double v) const {
    return (1 - v) * ((1 - u) * lower[0] + u * lower[1]) + v * ((1 - u) * upper[0] + u * upper[1]);
  }
};

// All panels. The lower part of each precedes its upper part.
std::vector<PanelOutline> panel_outlines(const Scenario& scenario);

// Upper bound of the number of elements of the pocket's mesh. A double because it may be very large.
double largest_element_count(const Scenario& scenario);

}  // namespace netpocket
