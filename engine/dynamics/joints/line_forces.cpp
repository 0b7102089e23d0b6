#include "engine/dynamics/joints/line_forces.h"

#include <algorithm>

#include "engine/math/symmetric_algebra.h"

namespace netpocket {

LineForces line_forces(const TensionLine& line, const Eigen::Vector3d& chord, const Eigen::Vector3d& chord_rate) {
  LineForces result{.on_node1 = Eigen::Vector3d::Zero()};
  const double distance = symmetric_norm(chord), extension = distance - line.length;
  if (extension <= 0) return result;
  const Eigen::Vector3d along = chord / distance;
  const double rate = symmetric_dot(along, chord_rate);
  result.tension = std::max(line.stiffness * extension + line.damping * rate, 0.0);
  result.on_node1 = result.tension * along;
  result.energy = 0.5 * line.stiffness * extension * extension;
  // What flows into the line and is not stored.
  result.dissipated_power = (result.tension - line.stiffness * extension) * rate;
  return result;
}

}  // namespace netpocket
