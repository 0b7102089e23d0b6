#include "engine/ancf/variable_length.h"

#include "engine/ancf/mass.h"

namespace netpocket {
namespace {

// Chord gradient e, and the velocity of the material relative to each node.
struct Flow {
  Flow(const MaterialSpan& span, const ElementCoordinates& q)
      : e((q.col(2) - q.col(0)) / span.length), past1(-span.start_rate * e), past2(-span.end_rate * e) {}

  Eigen::Vector3d e, past1, past2;
};

}  // namespace

double kinetic_energy(double mass_per_length, const MaterialSpan& span, const ElementCoordinates& q,
                      const ElementCoordinates& velocity) {
  const Flow flow(span, q);
  const NodalWeights mass = lumped_mass(mass_per_length, span.length);
  return 0.5 * (mass[0] * squared_norm(velocity.col(0) + flow.past1) + mass[1] * squared_norm(velocity.col(1)) +
                mass[2] * squared_norm(velocity.col(2) + flow.past2) + mass[3] * squared_norm(velocity.col(3)));
}

ElementCoordinates flow_momentum(double mass_per_length, const MaterialSpan& span, const ElementCoordinates& q) {
  const Flow flow(span, q);
  const double node_mass = mass_per_length * span.length / 2;
  ElementCoordinates momentum = ElementCoordinates::Zero();
  momentum.col(0) = node_mass * flow.past1;
  momentum.col(2) = node_mass * flow.past2;
  return momentum;
}

ElementCoordinates flow_force(double mass_per_length, const MaterialSpan& span, const ElementCoordinates& q,
                              const ElementCoordinates& velocity) {
  const Flow flow(span, q);
  const Eigen::Vector3d carried = (mass_per_length / 2) * (span.start_rate * (velocity.col(0) + flow.past1) +
                                                           span.end_rate * (velocity.col(2) + flow.past2));
  ElementCoordinates force = ElementCoordinates::Zero();
  force.col(0) = carried;
  force.col(2) = -carried;
  return force;
}

double flow_work(double mass_per_length, const MaterialSpan& span, const ElementCoordinates& q,
                 const ElementCoordinates& velocity) {
  const Flow flow(span, q);
  return mass_per_length * span.length / 2 *
         (dot(flow.past1, velocity.col(0) + flow.past1) + dot(flow.past2, velocity.col(2) + flow.past2));
}

}  // namespace netpocket
