#pragma once
// Forces of lines without mass (model.h): a spring and a damper side by side that pull and never push, as models of
// tethers have them (e.g. Boonrath, Singh & Botta 2024, doi:10.1016/j.actaastro.2024.09.022).
//
// With the distance d of the nodes, the extension x = d - length and its rate v: the tension is max(k x + c v, 0) where
// x > 0, and 0 where the line is slack. Where the damper would push, the line holds its nodes with no force. Its spring
// then gives its energy to its own damper, so the power lost is -k x v.

#include <Eigen/Core>

#include "engine/model/model.h"

namespace netpocket {

struct LineForces {
  Eigen::Vector3d on_node1;     // N; the opposite acts on node 2
  double tension = 0;           // N, >= 0
  double energy = 0;            // J, of the spring
  double dissipated_power = 0;  // W, >= 0
};

// `chord`: position of node 2 minus that of node 1 (m); `chord_rate`: likewise of velocities (m/s). The chord must not
// be zero where the line is taut.
LineForces line_forces(const TensionLine& line, const Eigen::Vector3d& chord, const Eigen::Vector3d& chord_rate);

}  // namespace netpocket
