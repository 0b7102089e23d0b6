#include "engine/dynamics/assembly/stable_step.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/ancf/full_element.h"
#include "engine/ancf/mass.h"
#include "engine/ancf/mean_strain_element.h"
#include "engine/ancf/strain_pair.h"
#include "engine/dynamics/assembly/consistent_mass.h"

namespace netpocket {
namespace {

using Vectors = std::vector<Eigen::Vector3d>;

// Strain energy of a mode in an element, by kind. Tells what kind of mode limits the step.
struct ModeEnergy {
  double axial = 0;
  double bending = 0;
};

// Unit vectors along the chords, by element; zero where a cable has no chord.
Vectors chord_directions(std::span<const BatchElement> elements, const CoordinateVectors& q) {
  Vectors directions;
  for (const BatchElement& element : elements) {
    directions.push_back((q.get(element.coordinate[2]) - q.get(element.coordinate[0])).stableNormalized());
  }
  return directions;
}

// Change of a straight element's strain with the displacements `x`.
double strain_change(const BatchElement& element, const Eigen::Vector3d& direction, const Vectors& x) {
  return direction.dot(x[element.coordinate[2]] - x[element.coordinate[0]]) / element.length;
}

// Adds (K + factor C) x of one element to `product`, with K of the mean-strain element without tension. Returns its
// energy and adds to `damping`.
ModeEnergy add_element_product(std::span<const BatchElement> elements, std::size_t index, const Vectors& directions,
                               double factor, const Vectors& x, Vectors& product, ModeEnergy& damping) {
  const BatchElement& element = elements[index];
  const auto [r1, g1, r2, g2] = element.coordinate;
  const double inverse_length = 1 / element.length;
  const CableSection& section = element.section;

  const Eigen::Vector3d chord = (x[r2] - x[r1]) * inverse_length;
  const double own = directions[index].dot(chord);
  const auto strain_partner = static_cast<std::size_t>(element.strain_partner);
  const double strain =
      element.strain_partner < 0
          ? own
          : paired_strain(own, strain_change(elements[strain_partner], directions[strain_partner], x));
  const double tension = section.EA * (1 + factor * section.axial_damping) * strain;
  const Eigen::Vector3d s = x[g1] - x[g2], a = x[g1] + x[g2] - 2 * chord;
  const double bending = section.EI * inverse_length * (1 + factor * section.bending_damping);
  const Eigen::Vector3d moment_s = bending * s, moment_a = 3 * bending * a;

  const Eigen::Vector3d force2 = tension * directions[index] - 2 * inverse_length * moment_a;
  product[r1] -= force2;
  product[r2] += force2;
  product[g1] += moment_s + moment_a;
  product[g2] += moment_a - moment_s;

  const ModeEnergy energy{section.EA * element.length * strain * own,
                          section.EI * inverse_length * (s.squaredNorm() + 3 * a.squaredNorm())};
  damping.axial += section.axial_damping * energy.axial;
  damping.bending += section.bending_damping * energy.bending;
  return energy;
}

// The tension lines of a model, and the parts of its ropes through rings as stiff as they can become.
std::vector<TensionLine> stiffest_lines(const Model& model) {
  std::vector<TensionLine> lines = model.lines;
  for (const RingRope& rope : model.ring_ropes) {
    const double least = std::min(rope.least_part, *std::ranges::min_element(rope.lengths));
    const double stiffness = rope.stiffness / least;
    for (std::size_t i = 0; i + 1 < rope.nodes.size(); ++i) {
      lines.push_back({rope.nodes[i], rope.nodes[i + 1], least, stiffness, rope.damping * stiffness});
    }
  }
  return lines;
}

// A deterministic start vector with contributions of all modes.
Vectors start_vector(std::int32_t size) {
  Vectors x(size);
  std::uint32_t seed = 1;
  const auto next = [&seed] {
    seed = seed * 1664525u + 1013904223u;
    return seed / 4294967296.0 - 0.5;
  };
  for (Eigen::Vector3d& v : x) v = {next(), next(), next()};
  return x;
}

}  // namespace

std::string limit_text(const Model& model, StepLimit limit, std::int32_t thread) {
  const auto index = static_cast<std::size_t>(thread);
  const std::string name = index < model.threads.size() ? model.threads[index] : "the cables";
  switch (limit) {
    case StepLimit::axial_waves:
      return "axial waves in " + name;
    case StepLimit::bending_waves:
      return "bending waves in " + name;
    case StepLimit::full_element:
      return "the full element's stiffness in " + name;
    case StepLimit::hinge:
      return "a rod's kink";
    case StepLimit::line:
      return "a tension line";
    case StepLimit::nothing:
      break;
  }
  return "nothing moves";
}

double stable_step_of_mode(double stiffness, double damping) {
  if (stiffness <= 0) return std::numeric_limits<double>::infinity();
  return (std::sqrt(damping * damping + 4 * stiffness) - damping) / stiffness;
}

StableStep find_stable_step(const Model& model, const CoordinateLayout& layout, std::span<const BatchElement> elements,
                            std::span<const double> inverse_mass, const CoordinateVectors& coordinates) {
  constexpr int kIterations = 120, kLeastIterations = 30;
  constexpr double kSettled = 2e-5;  // relative change of the step in one iteration
  constexpr double kMargin = 1.02;  // safety: the Rayleigh quotient approaches the highest squared frequency from below
  Vectors x = start_vector(coordinates.size()), product(x.size());
  const Vectors directions = chord_directions(elements, coordinates);
  const std::vector<TensionLine> lines = stiffest_lines(model);
  double step = 1e-4;
  StableStep result{.step = std::numeric_limits<double>::infinity()};
  for (int iteration = 0; iteration < kIterations; ++iteration) {
    for (std::size_t i = 0; i < x.size(); ++i) {
      if (inverse_mass[i] == 0) x[i].setZero();
      product[i].setZero();
    }
    double kinetic = 0, potential = 0, dissipation = 0, largest = -1;
    const auto consider = [&](double energy, StepLimit limit, std::int32_t thread) {
      if (energy <= largest) return;
      largest = energy;
      result.limit = limit;
      result.thread = thread;
    };
    const double factor = 2 / step;
    ModeEnergy damping;
    for (std::size_t i = 0; i < elements.size(); ++i) {
      const ModeEnergy energy = add_element_product(elements, i, directions, factor, x, product, damping);
      potential += energy.axial + energy.bending;
      consider(energy.axial + energy.bending,
               energy.axial > energy.bending ? StepLimit::axial_waves : StepLimit::bending_waves,
               model.elements[i].thread);
    }
    for (const Hinge& hinge : model.hinges) {
      const std::int32_t g1 = layout.gradient(hinge.gradient1), g2 = layout.gradient(hinge.gradient2);
      const Eigen::Vector3d bend = x[g2] - x[g1];  // the rest rotation does not change the magnitude of the stiffness
      const double stiffness = hinge.stiffness + factor * hinge.damping;
      product[g2] += stiffness * bend;
      product[g1] -= stiffness * bend;
      potential += hinge.stiffness * bend.squaredNorm();
      dissipation += hinge.damping * bend.squaredNorm();
      consider(hinge.stiffness * bend.squaredNorm(), StepLimit::hinge, 0);
    }
    for (const TensionLine& line : lines) {
      const std::int32_t r1 = layout.position(line.node1), r2 = layout.position(line.node2);
      const Eigen::Vector3d along = (coordinates.get(r2) - coordinates.get(r1)).stableNormalized();
      const double stretch = along.dot(x[r2] - x[r1]);
      const Eigen::Vector3d force = (line.stiffness + factor * line.damping) * stretch * along;
      product[r2] += force;
      product[r1] -= force;
      potential += line.stiffness * stretch * stretch;
      dissipation += line.damping * stretch * stretch;
      consider(line.stiffness * stretch * stretch, StepLimit::line, 0);
    }
    dissipation += damping.axial + damping.bending;
    double norm = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      if (inverse_mass[i] == 0) continue;
      kinetic += x[i].squaredNorm() / inverse_mass[i];
      x[i] = product[i] * inverse_mass[i];
      norm = std::max(norm, x[i].cwiseAbs().maxCoeff());
    }
    if (kinetic == 0 || norm == 0) return result;
    for (Eigen::Vector3d& v : x) v /= norm;
    result.stiffness = kMargin * potential / kinetic;
    result.damping = kMargin * dissipation / kinetic;
    const double before = step;
    result.step = step = stable_step_of_mode(result.stiffness, result.damping);
    if (!std::isfinite(step)) return result;
    if (iteration >= kLeastIterations && std::abs(step - before) < kSettled * step) break;
  }
  return result;
}

StableStep with_lines(const Model& model, const CoordinateLayout& layout, std::span<const double> inverse_mass,
                      const StableStep& without) {
  std::vector<double> stiffness(inverse_mass.size(), 0.0), damping(inverse_mass.size(), 0.0);
  const std::vector<TensionLine> lines = stiffest_lines(model);
  for (const TensionLine& line : lines) {
    for (const std::int32_t node : {line.node1, line.node2}) {
      const auto place = static_cast<std::size_t>(layout.position(node));
      stiffness[place] += 2 * line.stiffness * inverse_mass[place];
      damping[place] += 2 * line.damping * inverse_mass[place];
    }
  }
  if (lines.empty()) return without;
  StableStep result = without;
  const double of_lines = *std::ranges::max_element(stiffness);
  if (of_lines > result.stiffness) result.limit = StepLimit::line;
  result.stiffness += of_lines;
  result.damping += *std::ranges::max_element(damping);
  result.step = stable_step_of_mode(result.stiffness, result.damping);
  return result;
}

namespace {

// Stiffness and damping that hinges add to an element, by corner. The energy k |g2 - g1|^2/2 of a hinge is at most
// k |g1|^2 + k |g2|^2. One of the two terms goes to an element at either side, which bounds the energy from above.
struct HingeShare {
  Eigen::Vector4d stiffness = Eigen::Vector4d::Zero();
  Eigen::Vector4d damping = Eigen::Vector4d::Zero();
};

std::vector<HingeShare> hinge_shares(const Model& model) {
  std::vector<HingeShare> shares(model.elements.size());
  const auto add = [&](std::int32_t gradient, const Hinge& hinge) {
    for (std::size_t i = 0; i < shares.size(); ++i) {
      const ModelElement& element = model.elements[i];
      if (element.gradient1 != gradient && element.gradient2 != gradient) continue;
      const int corner = element.gradient1 == gradient ? 1 : 3;
      shares[i].stiffness[corner] += 2 * hinge.stiffness;
      shares[i].damping[corner] += 2 * hinge.damping;
      return;
    }
  };
  for (const Hinge& hinge : model.hinges) {
    add(hinge.gradient1, hinge);
    add(hinge.gradient2, hinge);
  }
  return shares;
}

// Smallest stable step over the modes of one free element. `axial`, `bending`: its tangents with only one of the two
// stiffnesses. `mass`: its mass matrix, which is the same for each component.
StableStep smallest_over_modes(const CableSection& section, const ElementTangent& axial, const ElementTangent& bending,
                               const Eigen::Matrix4d& mass, const HingeShare& hinges) {
  const auto by_component = [](const Eigen::Vector4d& by_corner) {
    return by_corner.transpose().replicate<3, 1>().reshaped().eval();
  };
  ElementTangent mass_matrix = ElementTangent::Zero();
  for (int a = 0; a < 4; ++a) {
    for (int b = 0; b < 4; ++b) mass_matrix.block<3, 3>(3 * a, 3 * b) = mass(a, b) * Eigen::Matrix3d::Identity();
  }
  ElementTangent stiffness = axial + bending;
  stiffness.diagonal() += by_component(hinges.stiffness);
  const Eigen::GeneralizedSelfAdjointEigenSolver<ElementTangent> modes(stiffness, mass_matrix);
  StableStep smallest{.step = std::numeric_limits<double>::infinity()};
  for (int i = 0; i < 12; ++i) {
    const auto mode = modes.eigenvectors().col(i);
    const double damping =
        std::max(section.axial_damping * mode.dot(axial * mode) + section.bending_damping * mode.dot(bending * mode) +
                     mode.dot(by_component(hinges.damping).cwiseProduct(mode)),
                 0.0);
    const double square = modes.eigenvalues()[i], step = stable_step_of_mode(square, damping);
    if (step < smallest.step) smallest = {.step = step, .stiffness = square, .damping = damping};
  }
  return smallest;
}

template <typename Element>
StableStep stable_step_of_element(const CableSection& section, double length, const Eigen::Matrix4d& mass,
                                  const ElementCoordinates& q, const HingeShare& hinges = {}) {
  CableSection axial = section, bending = section;
  axial.EI = 0;
  bending.EA = 0;
  const MaterialSpan span{.length = length};
  return smallest_over_modes(section, Element(axial, span).tangent(q), Element(bending, span).tangent(q), mass, hinges);
}

}  // namespace

StableStep find_stable_step_of_full_elements(const Model& model, std::span<const BatchElement> elements,
                                             const CoordinateVectors& coordinates) {
  StableStep result{.step = std::numeric_limits<double>::infinity()};
  const std::vector<std::uint8_t> lumped = lumped_elements(model);
  const std::vector<HingeShare> hinges = hinge_shares(model);
  for (std::size_t i = 0; i < elements.size(); ++i) {
    ElementCoordinates q;
    for (int corner = 0; corner < 4; ++corner) q.col(corner) = coordinates.get(elements[i].coordinate[corner]);
    CableSection section = elements[i].section;
    section.compression = 1;  // a cable that is slack now may be taut later
    Eigen::Matrix4d mass = consistent_mass(section.mass_per_length, elements[i].length);
    if (lumped[i] != 0) mass = lumped_mass(section.mass_per_length, elements[i].length).asDiagonal();
    const StableStep own = stable_step_of_element<FullElement>(section, elements[i].length, mass, q, hinges[i]);
    if (own.step >= result.step) continue;
    result = own;
    result.limit = StepLimit::full_element;
    result.thread = model.elements[i].thread;
  }
  return result;
}

namespace {

template <typename Element>
double stable_step_of_straight_lumped_element(const CableSection& section, double length) {
  ElementCoordinates straight = ElementCoordinates::Zero();
  straight(0, 1) = straight(0, 3) = 1;
  straight(0, 2) = length;
  const Eigen::Matrix4d mass = lumped_mass(section.mass_per_length, length).asDiagonal();
  return stable_step_of_element<Element>(section, length, mass, straight).step;
}

}  // namespace

double stable_step_of_lumped_element(const CableSection& single, double length, bool paired) {
  CableSection section = single;
  // Modes of a free pair: the one that stretches both elements alike has half the squared frequency of a single
  // element, the other one kPairVariation times that.
  if (paired) section.EA *= std::max(0.5, kPairVariation);
  return stable_step_of_straight_lumped_element<MeanStrainElement>(section, length);
}

double stable_step_of_lumped_full_element(const CableSection& section, double length) {
  return stable_step_of_straight_lumped_element<FullElement>(section, length);
}

}  // namespace netpocket
