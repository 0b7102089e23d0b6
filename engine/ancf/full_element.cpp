#include "engine/ancf/full_element.h"

#include <algorithm>
#include <limits>

#include "engine/ancf/quadrature.h"
#include "engine/ancf/shape_functions.h"
#include "engine/ancf/strain_measure.h"

namespace netpocket {
namespace {

// r' of the element at xi, and its rate at the material point. The rate includes `convected`, the part due to the
// motion of the material through the element.
struct Slope {
  Slope(double xi, const MaterialSpan& span, const ElementCoordinates& q, const ElementCoordinates& velocity)
      : weights(shape_p(xi, span.length)),
        value(combine(q, weights)),
        convected(combine(q, shape_p_rate(xi, span))),
        rate(combine(velocity, weights) + convected) {}

  NodalWeights weights;
  Eigen::Vector3d value, convected, rate;
};

// The same for r''.
struct Bend {
  Bend(double xi, const MaterialSpan& span, const ElementCoordinates& q, const ElementCoordinates& velocity)
      : weights(shape_pp(xi, span.length)),
        value(combine(q, weights)),
        convected(combine(q, shape_pp_rate(xi, span))),
        rate(combine(velocity, weights) + convected) {}

  NodalWeights weights;
  Eigen::Vector3d value, convected, rate;
};

// Axial force at a point, split into its elastic and damping part.
struct AxialForce {
  AxialForce(const Slope& a, const CableSection& section, StrainMeasure measure) : strain(a.value, measure) {
    const double EA = section.axial_stiffness(strain.value);
    elastic = EA * strain.value;
    damping = EA * section.axial_damping * dot(strain.gradient, a.rate);
  }

  AxialStrain strain;
  double elastic, damping;
};

// Stress conjugate to kappa^2, M/(2 kappa), split into EI/2 (elastic) and c EI/2 (dkappa/dt)/kappa (damping).
struct BendingForce {
  BendingForce(const Slope& a, const Bend& b, const CableSection& section, double length,
               const FullElementOptions& options)
      : curvature(a.value, b.value, options), elastic(section.EI / 2) {
    const double round_off = kBendingRoundOff / length;
    const double rate = dot(curvature.gradient_a, a.rate) + dot(curvature.gradient_b, b.rate);
    damping = section.bending_damping * section.EI / 4 * rate / (curvature.value + round_off * round_off);
  }

  SquaredCurvature curvature;
  double elastic, damping;
};

void add_force(ElementCoordinates& force, const NodalWeights& weights, const Eigen::Vector3d& density) {
  for (int i = 0; i < 4; ++i) force.col(i) += weights[i] * density;
}

// tangent_ij += left_i right_j block
void add_tangent(ElementTangent& tangent, const NodalWeights& left, const Eigen::Matrix3d& block,
                 const NodalWeights& right) {
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) tangent.block<3, 3>(3 * i, 3 * j) += left[i] * right[j] * block;
  }
}

}  // namespace

double FullElement::tension(double xi, const ElementCoordinates& q, const ElementCoordinates& velocity) const {
  const AxialForce axial(Slope(xi, span_, q, velocity), section_, options_.measure);
  return axial.elastic + axial.damping;
}

FullElement::Stretching FullElement::stretching(const ElementCoordinates& q, const ElementCoordinates& velocity) const {
  Stretching mean{.largest_strain = -std::numeric_limits<double>::infinity()};
  for (const auto& [xi, weight] : kGauss5) {
    const AxialForce axial(Slope(xi, span_, q, velocity), section_, options_.measure);
    mean.strain += 0.5 * weight * axial.strain.value;
    mean.tension += 0.5 * weight * (axial.elastic + axial.damping);
    mean.largest_strain = std::max(mean.largest_strain, axial.strain.value);
  }
  return mean;
}

double FullElement::axial_energy(const ElementCoordinates& q) const {
  double energy = 0;
  for (const auto& [xi, weight] : kGauss5) {
    const double eps = AxialStrain(combine(q, shape_p(xi, span_.length)), options_.measure).value;
    energy += weight * section_.axial_stiffness(eps) * eps * eps;
  }
  return energy * span_.length / 4;
}

double FullElement::bending_energy(const ElementCoordinates& q) const {
  double energy = 0;
  for (const auto& [xi, weight] : kGauss3) {
    const double L = span_.length;
    energy += weight * SquaredCurvature(combine(q, shape_p(xi, L)), combine(q, shape_pp(xi, L)), options_).value;
  }
  return section_.EI * energy * span_.length / 4;
}

ElementCoordinates FullElement::internal_force(const ElementCoordinates& q, const ElementCoordinates& velocity) const {
  ElementCoordinates force = ElementCoordinates::Zero();
  for (const auto& [xi, weight] : kGauss5) {
    const Slope a(xi, span_, q, velocity);
    const AxialForce axial(a, section_, options_.measure);
    add_force(force, a.weights, weight * (axial.elastic + axial.damping) * axial.strain.gradient);
  }
  for (const auto& [xi, weight] : kGauss3) {
    const Slope a(xi, span_, q, velocity);
    const Bend b(xi, span_, q, velocity);
    const BendingForce bending(a, b, section_, span_.length, options_);
    const double stress = weight * (bending.elastic + bending.damping);
    add_force(force, a.weights, stress * bending.curvature.gradient_a);
    add_force(force, b.weights, stress * bending.curvature.gradient_b);
  }
  return force * (span_.length / 2);
}

ElementTangent FullElement::tangent(const ElementCoordinates& q) const {
  ElementTangent tangent = ElementTangent::Zero();
  for (const auto& [xi, weight] : kGauss5) {
    const NodalWeights weights = shape_p(xi, span_.length);
    const Eigen::Vector3d a = combine(q, weights);
    const AxialStrain strain(a, options_.measure);
    const double EA = section_.axial_stiffness(strain.value);
    const Eigen::Matrix3d stiffness =
        EA * (strain.gradient * strain.gradient.transpose() + strain.value * axial_strain_hessian(a, options_.measure));
    add_tangent(tangent, weights, weight * stiffness, weights);
  }
  for (const auto& [xi, weight] : kGauss3) {
    const NodalWeights slope = shape_p(xi, span_.length), bend = shape_pp(xi, span_.length);
    const SquaredCurvatureHessian hessian(combine(q, slope), combine(q, bend), options_);
    const double stress = weight * section_.EI / 2;
    add_tangent(tangent, slope, stress * hessian.aa, slope);
    add_tangent(tangent, slope, stress * hessian.ab, bend);
    add_tangent(tangent, bend, stress * hessian.ab.transpose(), slope);
    add_tangent(tangent, bend, stress * hessian.bb, bend);
  }
  return tangent * (span_.length / 2);
}

double FullElement::dissipated_power(const ElementCoordinates& q, const ElementCoordinates& velocity) const {
  double power = 0;
  for (const auto& [xi, weight] : kGauss5) {
    const Slope a(xi, span_, q, velocity);
    const AxialForce axial(a, section_, options_.measure);
    power += weight * axial.damping * dot(axial.strain.gradient, a.rate);
  }
  for (const auto& [xi, weight] : kGauss3) {
    const Slope a(xi, span_, q, velocity);
    const Bend b(xi, span_, q, velocity);
    const BendingForce bending(a, b, section_, span_.length, options_);
    const SquaredCurvature& curvature = bending.curvature;
    power += weight * bending.damping * (dot(curvature.gradient_a, a.rate) + dot(curvature.gradient_b, b.rate));
  }
  return power * span_.length / 2;
}

double FullElement::feeding_power(const ElementCoordinates& q, const ElementCoordinates& velocity) const {
  // The elastic energy changes with L at fixed q and xi. The damping stresses also do work on the motion of the
  // material through the element, which is not part of the nodes' velocities.
  const double L = span_.length;
  const double growth = span_.length_rate();
  double power = 0;
  for (const auto& [xi, weight] : kGauss5) {
    const Slope a(xi, span_, q, velocity);
    const AxialForce axial(a, section_, options_.measure);
    const Eigen::Vector3d lengthening = growth * combine(q, shape_p_L(xi, L));
    power += weight * dot(axial.strain.gradient, axial.elastic * lengthening + axial.damping * a.convected);
  }
  for (const auto& [xi, weight] : kGauss3) {
    const Slope a(xi, span_, q, velocity);
    const Bend b(xi, span_, q, velocity);
    const BendingForce bending(a, b, section_, L, options_);
    const Eigen::Vector3d a_lengthening = growth * combine(q, shape_p_L(xi, L));
    const Eigen::Vector3d b_lengthening = growth * combine(q, shape_pp_L(xi, L));
    power +=
        weight * (dot(bending.curvature.gradient_a, bending.elastic * a_lengthening + bending.damping * a.convected) +
                  dot(bending.curvature.gradient_b, bending.elastic * b_lengthening + bending.damping * b.convected));
  }
  return power * L / 2 + (axial_energy(q) + bending_energy(q)) * growth / L;
}

}  // namespace netpocket
