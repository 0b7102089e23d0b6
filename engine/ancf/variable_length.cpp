#include "engine/ancf/variable_length.h"

#include "engine/ancf/quadrature.h"
#include "engine/ancf/shape_functions.h"

namespace netpocket {

// Products of two cubics: four Gauss points are exact throughout.

SpanInertia::SpanInertia(double mass_per_length, const MaterialSpan& span) {
  mass.setZero();
  mass_velocity.setZero();
  mass_position.setZero();
  for (const auto& [xi, weight] : kGauss4) {
    const NodalWeights s = shape(xi, span.length);
    const NodalWeights weighted = s * (weight * mass_per_length * span.length / 2);
    mass += weighted * s.transpose();
    mass_velocity += weighted * shape_rate(xi, span).transpose();
    mass_position += weighted * shape_acceleration(xi, span).transpose();
  }
}

ElementCoordinates SpanInertia::flow_force(const ElementCoordinates& q, const ElementCoordinates& velocity) const {
  return 2 * apply(mass_velocity, velocity) + apply(mass_position, q);
}

ElementCoordinates apply(const Eigen::Matrix4d& matrix, const ElementCoordinates& columns) {
  ElementCoordinates result;
  for (int i = 0; i < 4; ++i) result.col(i) = combine(columns, matrix.row(i).transpose());
  return result;
}

double kinetic_energy(double mass_per_length, const MaterialSpan& span, const ElementCoordinates& q,
                      const ElementCoordinates& velocity) {
  double energy = 0;
  for (const auto& [xi, weight] : kGauss4) energy += weight * squared_norm(material_velocity(xi, span, q, velocity));
  return mass_per_length * energy * span.length / 4;
}

double inertia_feeding_power(double mass_per_length, const MaterialSpan& span, const ElementCoordinates& q,
                             const ElementCoordinates& velocity, const ElementCoordinates& acceleration) {
  double through = 0;
  for (const auto& [xi, weight] : kGauss4) {
    through +=
        weight * dot(combine(q, shape_rate(xi, span)), material_acceleration(xi, span, q, velocity, acceleration));
  }
  const double in_at_end = squared_norm(material_velocity(1, span, q, velocity)) * span.end_rate;
  const double out_at_start = squared_norm(material_velocity(-1, span, q, velocity)) * span.start_rate;
  return mass_per_length * (through * span.length + in_at_end - out_at_start) / 2;
}

}  // namespace netpocket
