#include "engine/ancf/mass.h"

namespace netpocket {

Eigen::Matrix4d consistent_mass(double mass_per_length, double length) {
  const double L = length;
  Eigen::Matrix4d m;
  m << 13. / 35, 11 * L / 210, 9. / 70, -13 * L / 420,          //
      11 * L / 210, L * L / 105, 13 * L / 420, -L * L / 140,    //
      9. / 70, 13 * L / 420, 13. / 35, -11 * L / 210,           //
      -13 * L / 420, -L * L / 140, -11 * L / 210, L * L / 105;  //
  return mass_per_length * L * m;
}

NodalWeights lumped_mass(double mass_per_length, double length) {
  const double position = mass_per_length * length / 2;
  const double gradient = mass_per_length * length * length * length / 78;
  return {position, gradient, position, gradient};
}

NodalWeights uniform_load(double length) {
  return {length / 2, length * length / 12, length / 2, -length * length / 12};
}

}  // namespace netpocket
