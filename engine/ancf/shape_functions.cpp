#include "engine/ancf/shape_functions.h"

namespace netpocket {

NodalWeights shape(double xi, double length) {
  const double minus = (xi - 1) * (xi - 1) / 4;
  const double plus = (xi + 1) * (xi + 1) / 4;
  return {minus * (xi + 2), length / 2 * minus * (xi + 1), -plus * (xi - 2), length / 2 * plus * (xi - 1)};
}

NodalWeights shape_xi(double xi, double length) {
  const double bubble = 3 * (xi - 1) * (xi + 1) / 4;
  return {bubble, length / 8 * (xi - 1) * (3 * xi + 1), -bubble, length / 8 * (xi + 1) * (3 * xi - 1)};
}

NodalWeights shape_xixi(double xi, double length) {
  return {1.5 * xi, length / 4 * (3 * xi - 1), -1.5 * xi, length / 4 * (3 * xi + 1)};
}

NodalWeights shape_p(double xi, double length) { return shape_xi(xi, length) * (2 / length); }

NodalWeights shape_pp(double xi, double length) { return shape_xixi(xi, length) * (4 / (length * length)); }

// S2 and S4 are proportional to L. S1 and S3 do not depend on L.
NodalWeights shape_L(double xi) {
  return {0, (xi - 1) * (xi - 1) * (xi + 1) / 8, 0, (xi + 1) * (xi + 1) * (xi - 1) / 8};
}

NodalWeights shape_xiL(double xi) { return {0, (xi - 1) * (3 * xi + 1) / 8, 0, (xi + 1) * (3 * xi - 1) / 8}; }

NodalWeights shape_p_L(double xi, double length) {
  const NodalWeights s = shape_p(xi, length);
  return {-s[0] / length, 0, -s[2] / length, 0};
}

NodalWeights shape_pp_L(double xi, double length) {
  const NodalWeights s = shape_pp(xi, length);
  return {-2 * s[0] / length, -s[1] / length, -2 * s[2] / length, -s[3] / length};
}

}  // namespace netpocket
