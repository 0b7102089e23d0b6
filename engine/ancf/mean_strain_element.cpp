#include "engine/ancf/mean_strain_element.h"

namespace netpocket {
namespace {

// Chord gradient and the deviations from it (mean_strain_element.h), or their rates.
struct Deformation {
  Eigen::Vector3d e, h1, h2;

  Eigen::Vector3d even() const { return h1 - h2; }
  Eigen::Vector3d odd() const { return h1 + h2; }
};

Deformation deformation(const ElementCoordinates& q, double length) {
  const Eigen::Vector3d e = (q.col(2) - q.col(0)) / length;
  return {e, q.col(1) - e, q.col(3) - e};
}

// Rate of `now` = deformation(q). A growing length shortens e.
Deformation deformation_rate(const Deformation& now, const ElementCoordinates& velocity, const MaterialSpan& span) {
  const Deformation at_fixed_length = deformation(velocity, span.length);
  const Eigen::Vector3d stretching = now.e * (span.length_rate() / span.length);
  return {at_fixed_length.e - stretching, at_fixed_length.h1 + stretching, at_fixed_length.h2 + stretching};
}

// d(strain)/de, /dh1, /dh2.
Deformation strain_gradient(const Deformation& d) { return {d.e, (4 * d.h1 - d.h2) / 30, (4 * d.h2 - d.h1) / 30}; }

double rate_of_strain(const Deformation& gradient, const Deformation& rate) {
  return dot(gradient.e, rate.e) + (dot(gradient.h1, rate.h1) + dot(gradient.h2, rate.h2));
}

// Vector of length d|mode|/dt in the direction of the mode: mode (mode.rate)/(mode.mode).
Eigen::Vector3d radial_rate(const Eigen::Vector3d& mode, const Eigen::Vector3d& rate) {
  return mode * (dot(mode, rate) / (squared_norm(mode) + kBendingRoundOff * kBendingRoundOff));
}

// Damping forces conjugate to the two bending modes, N m.
struct ModalForces {
  Eigen::Vector3d even, odd;
};

ModalForces bending_damping(const Deformation& d, const Deformation& rate, const CableSection& section, double length) {
  const double stiffness = section.bending_damping * section.EI / length;
  return {stiffness * radial_rate(d.even(), rate.even()), 3 * stiffness * radial_rate(d.odd(), rate.odd())};
}

// Generalised forces that correspond to forces conjugate to e, h1, h2.
ElementCoordinates nodal_forces(const Deformation& conjugate, double length) {
  ElementCoordinates force;
  const Eigen::Vector3d end = (conjugate.e - (conjugate.h1 + conjugate.h2)) / length;
  force << -end, conjugate.h1, end, conjugate.h2;
  return force;
}

}  // namespace

double MeanStrainElement::strain(const ElementCoordinates& q) const {
  const Deformation d = deformation(q, span_.length);
  const double waviness = 2 * (squared_norm(d.h1) + squared_norm(d.h2)) - dot(d.h1, d.h2);
  return (squared_norm(d.e) - 1 + waviness / 15) / 2;
}

double MeanStrainElement::strain_rate(const ElementCoordinates& q, const ElementCoordinates& velocity) const {
  const Deformation d = deformation(q, span_.length);
  return rate_of_strain(strain_gradient(d), deformation_rate(d, velocity, span_));
}

double MeanStrainElement::tension(const ElementCoordinates& q, const ElementCoordinates& velocity) const {
  const double eps = strain(q);
  return section_.axial_stiffness(eps) * (eps + section_.axial_damping * strain_rate(q, velocity));
}

double MeanStrainElement::axial_energy(const ElementCoordinates& q) const {
  const double eps = strain(q);
  return section_.axial_stiffness(eps) * span_.length * eps * eps / 2;
}

double MeanStrainElement::bending_energy(const ElementCoordinates& q) const {
  const Deformation d = deformation(q, span_.length);
  return section_.EI / (2 * span_.length) * (squared_norm(d.even()) + 3 * squared_norm(d.odd()));
}

ElementCoordinates MeanStrainElement::internal_force(const ElementCoordinates& q,
                                                     const ElementCoordinates& velocity) const {
  return internal_force(q, velocity, tension(q, velocity));
}

ElementCoordinates MeanStrainElement::internal_force(const ElementCoordinates& q, const ElementCoordinates& velocity,
                                                     double tension) const {
  const Deformation d = deformation(q, span_.length);
  const Deformation gradient = strain_gradient(d);
  const double axial = tension * span_.length;
  const ModalForces damping = bending_damping(d, deformation_rate(d, velocity, span_), section_, span_.length);
  const double bending = section_.EI / span_.length;
  return nodal_forces(
      {axial * gradient.e, axial * gradient.h1 + bending * (4 * d.h1 + 2 * d.h2) + (damping.odd + damping.even),
       axial * gradient.h2 + bending * (4 * d.h2 + 2 * d.h1) + (damping.odd - damping.even)},
      span_.length);
}

ElementTangent MeanStrainElement::tangent(const ElementCoordinates& q) const {
  // A unit change of q_j changes (e, h1, h2) by column j of B. The second derivatives of the energies are constant 3x3
  // matrices.
  const double L = span_.length;
  Eigen::Matrix<double, 3, 4> B;
  B << -1 / L, 0, 1 / L, 0, 1 / L, 1, -1 / L, 0, 1 / L, 0, -1 / L, 1;
  Eigen::Matrix3d axial, bending;
  axial << 30, 0, 0, 0, 4, -1, 0, -1, 4;
  bending << 0, 0, 0, 0, 4, 2, 0, 2, 4;
  const double eps = strain(q);
  const double EA = section_.axial_stiffness(eps);
  const Eigen::Matrix3d weights = EA * eps * L / 30 * axial + section_.EI / L * bending;
  const Eigen::Matrix4d isotropic = B.transpose() * weights * B;

  const ElementCoordinates strain_derivative = nodal_forces(strain_gradient(deformation(q, L)), L);
  const Eigen::Map<const Eigen::Matrix<double, 12, 1>> column(strain_derivative.data());
  ElementTangent tangent = EA * L * column * column.transpose();
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) tangent.block<3, 3>(3 * i, 3 * j).diagonal().array() += isotropic(i, j);
  }
  return tangent;
}

double MeanStrainElement::dissipated_power(const ElementCoordinates& q, const ElementCoordinates& velocity) const {
  const Deformation d = deformation(q, span_.length);
  const Deformation rate = deformation_rate(d, velocity, span_);
  const double strain_rate = rate_of_strain(strain_gradient(d), rate);
  const ModalForces damping = bending_damping(d, rate, section_, span_.length);
  const double axial = section_.axial_stiffness(strain(q)) * section_.axial_damping * span_.length;
  return axial * strain_rate * strain_rate + (dot(damping.even, rate.even()) + dot(damping.odd, rate.odd()));
}

double MeanStrainElement::feeding_power(const ElementCoordinates& q, const ElementCoordinates& velocity) const {
  // At fixed q a longer element has a shorter e: the conjugate force does work on de = -e dL/L. The length also scales
  // the axial energy and, inversely, the bending energy.
  const double L = span_.length;
  const Deformation d = deformation(q, L);
  const ElementCoordinates force = internal_force(q, velocity);
  const double conjugate_to_chord = dot(Eigen::Vector3d(force.col(2)), d.e);
  return span_.length_rate() * ((axial_energy(q) - bending_energy(q)) / L - conjugate_to_chord);
}

}  // namespace netpocket
