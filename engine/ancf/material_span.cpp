#include "engine/ancf/material_span.h"

#include "engine/ancf/shape_functions.h"

namespace netpocket {

double MaterialSpan::xi_rate(double xi) const { return -((1 - xi) * start_rate + (1 + xi) * end_rate) / length; }

double MaterialSpan::xi_acceleration(double xi) const {
  return -((1 - xi) * start_acceleration + (1 + xi) * end_acceleration) / length -
         2 * xi_rate(xi) * length_rate() / length;
}

NodalWeights shape_rate(double xi, const MaterialSpan& span) {
  return shape_xi(xi, span.length) * span.xi_rate(xi) + shape_L(xi) * span.length_rate();
}

NodalWeights shape_acceleration(double xi, const MaterialSpan& span) {
  const double rate = span.xi_rate(xi);
  return shape_xixi(xi, span.length) * (rate * rate) + shape_xiL(xi) * (2 * rate * span.length_rate()) +
         shape_xi(xi, span.length) * span.xi_acceleration(xi) + shape_L(xi) * span.length_acceleration();
}

NodalWeights shape_p_rate(double xi, const MaterialSpan& span) {
  const double p_rate = span.xi_rate(xi) * span.length / 2;  // d/dxi = (L/2) d/dp
  return shape_pp(xi, span.length) * p_rate + shape_p_L(xi, span.length) * span.length_rate();
}

NodalWeights shape_pp_rate(double xi, const MaterialSpan& span) {
  const double L = span.length;
  const NodalWeights shape_ppxi = NodalWeights{6 / L, 3, -6 / L, 3} / L;
  return shape_ppxi * span.xi_rate(xi) + shape_pp_L(xi, L) * span.length_rate();
}

Eigen::Vector3d material_velocity(double xi, const MaterialSpan& span, const ElementCoordinates& q,
                                  const ElementCoordinates& velocity) {
  return combine(velocity, shape(xi, span.length)) + combine(q, shape_rate(xi, span));
}

Eigen::Vector3d material_acceleration(double xi, const MaterialSpan& span, const ElementCoordinates& q,
                                      const ElementCoordinates& velocity, const ElementCoordinates& acceleration) {
  return combine(acceleration, shape(xi, span.length)) + combine(velocity, 2 * shape_rate(xi, span)) +
         combine(q, shape_acceleration(xi, span));
}

}  // namespace netpocket
