// V2: statics of the full evaluation with both measures, and of the mean-strain one.

#include <cmath>
#include <numbers>

#include "element_checks.h"
#include "engine/ancf/full_element.h"
#include "engine/ancf/mean_strain_element.h"
#include "static_solver.h"

namespace netpocket {
namespace {

using namespace test;

template <class Element>
ElasticElement elastic(const Element& element) {
  return {[=](const ElementCoordinates& q) { return element.axial_energy(q) + element.bending_energy(q); },
          [=](const ElementCoordinates& q) { return element.internal_force(q, ElementCoordinates::Zero()); },
          [=](const ElementCoordinates& q) { return element.tangent(q); }};
}

StaticChain full_chain(const CableSection& section, double length, int elements, StrainMeasure measure) {
  return {elements, length, elastic(FullElement(section, {.length = length / elements}, {.measure = measure}))};
}

StaticChain mean_strain_chain(const CableSection& section, double length, int elements) {
  return {elements, length, elastic(MeanStrainElement(section, {.length = length / elements}))};
}

// Square section, as in Exudyn's examples: E = 2.07e11.
CableSection square_section(double side) {
  const double E = 2.07e11;
  return {.EA = E * side * side, .EI = E * std::pow(side, 4) / 12};
}

void expect_tip(const std::string& what, const StaticResult& result, const Eigen::Vector2d& tip, double tolerance,
                const std::string& source) {
  std::printf("  %s: tip (%.10f, %.10f), %d iterations, residual %.0e\n", what.c_str(), result.tip().x(),
              result.tip().y(), result.iterations, result.residual);
  expect_error_below(what + ": tip, m", (result.tip().head<2>() - tip).norm(), tolerance, source);
}

// Cantilever under a dead transverse tip force 3 EI/L^2, Exudyn, Examples/ANCFcantileverTest.py; displacements of the
// tip. The clamp fixes the position and direction of the first node, not the length of its gradient: fixing that too
// over-constrains the strain there and costs the high order of convergence.
class VerificationCantilever : public VerificationTest {
 protected:
  StaticResult bend(const StaticChain& chain) const {
    return solve(chain, {.force = {0, -3 * section_.EI / (kLength * kLength), 0}}, 10);
  }
  StaticResult full(int elements, StrainMeasure measure) const {
    return bend(full_chain(section_, kLength, elements, measure));
  }
  StaticResult mean_strain(int elements) const { return bend(mean_strain_chain(section_, kLength, elements)); }
  static Eigen::Vector2d tip(double x, double y) { return {kLength + x, y}; }

  // Order of convergence from three meshes, each twice as fine.
  static double order(const StaticResult& coarse, const StaticResult& medium, const StaticResult& fine) {
    return std::log2((coarse.tip() - medium.tip()).norm() / (medium.tip() - fine.tip()).norm());
  }

  static constexpr const char* kExudyn =
      "Exudyn, Examples/ANCFcantileverTest.py (verification case V2): the digits given";
  static constexpr double kLength = 2;
  const CableSection section_ = square_section(0.1);
};

TEST_F(VerificationCantilever, MaterialMeasuresMatchThePublishedTip) {
  // Ten digits are given for 1 and 8 elements; 64 elements are published to be 2e-9 from the converged solution.
  expect_tip("cantilever, material, 1 element", full(1, StrainMeasure::material), tip(-0.3622447299, -0.9941447587),
             2e-10, kExudyn);
  expect_tip("cantilever, material, 8 elements", full(8, StrainMeasure::material), tip(-0.5085092365, -1.2071977560),
             2e-10, kExudyn);
  expect_tip("cantilever, material, 64 elements", full(64, StrainMeasure::material),
             tip(-0.508537304326, -1.207239854550), 5e-9, kExudyn);
}

TEST_F(VerificationCantilever, GreenMeasuresMatchTheReferenceTip) {
  // Eight digits are given.
  expect_tip("cantilever, green, 32 elements", full(32, StrainMeasure::green), tip(-0.50892284, -1.20839810), 1e-8,
             kExudyn);
}

TEST_F(VerificationCantilever, ElementsConverge) {
  // Cubic elements of a fourth-order problem: displacements of fourth order. One strain per element sees a curved
  // element's membrane strain to second order only.
  const auto order_of = [&](StrainMeasure measure) {
    return order(full(8, measure), full(16, measure), full(32, measure));
  };
  const double material = order_of(StrainMeasure::material), green = order_of(StrainMeasure::green);
  const double mean = order(mean_strain(8), mean_strain(16), mean_strain(32));
  const std::string source = "tips of 8, 16 and 32 elements; cubic elements: fourth order or better";
  expect_value("order of convergence, full, material measures", material, 5, 1, source);
  expect_value("order of convergence, full, green measures", green, 5, 1, source);
  expect_value("order of convergence, mean-strain", mean, 3, 0.6,
               "one strain per element sees the membrane strain of a curved one to second order");
}

TEST_F(VerificationCantilever, MeanStrainAgreesWithTheFullEvaluation) {
  // Their curvatures differ by a small power of |r'|, and |r'| from 1 by up to F/EA = 6e-4.
  const StaticResult mean = mean_strain(32);
  const double difference = (mean.tip() - full(32, StrainMeasure::green).tip()).norm();
  expect_error_below("cantilever, mean-strain against green / L", difference / kLength, 1e-3,
                     "their curvatures differ by a small power of the stretch, which is up to 6e-4");
}

// Inextensible elastica, Bisshopp & Drucker (1945): deflection/L and shortening/L for P L^2/EI.
class VerificationElastica : public VerificationTest {};

TEST_F(VerificationElastica, MatchesBisshoppAndDrucker) {
  struct Case {
    double load, deflection, shortening;
  };
  // EA L^2/EI = 1e8, as slender as 10 m of the net cord: stretched by 1e-7 of its length. Strain at five points per
  // element then resists bending (membrane locking), most at the largest load; one mean strain does not.
  const CableSection section{.EA = 1e8, .EI = 1};
  for (const auto& [load, deflection, shortening] : {Case{1, .30172077, .05643324}, Case{2, .49345748, .16064172},
                                                     Case{5, .71379152, .38762836}, Case{10, .81060902, .55499560}}) {
    const Eigen::Vector2d tip(1 - shortening, -deflection);
    const TipLoad force{.force = {0, -load, 0}};
    const std::string with = "elastica, P L^2/EI = " + std::to_string(static_cast<int>(load));
    const std::string source = "Bisshopp & Drucker (1945), 8 digits (verification case V2); L = 1 m, ";
    expect_tip(with + ", mean-strain, 32 elements", solve(mean_strain_chain(section, 1, 32), force, 10), tip, 1e-6,
               source + "order 2");
    expect_tip(with + ", full, 64 elements", solve(full_chain(section, 1, 64, StrainMeasure::material), force, 10), tip,
               2e-5, source + "membrane locking of five strains per element");
  }
}

// End moment 2 pi EI/L rolls a cantilever up into a full circle: tip at the clamp.
class VerificationRollUp : public VerificationTest {};

TEST_F(VerificationRollUp, ClosesTheCircle) {
  const double L = 2;
  const CableSection section = square_section(0.01);
  const TipLoad moment{.moment = 2 * std::numbers::pi * section.EI / L};
  // Reference errors of this element, two digits.
  for (const auto& [elements, reference] : {std::pair{8, 7.6e-3}, {16, 2.2e-4}, {32, 1.2e-5}}) {
    const StaticChain chain = full_chain(section, L, elements, StrainMeasure::material);
    const double error = solve(chain, moment, 20).tip().norm();
    expect_relative(
        "roll-up into a circle, full, material, " + std::to_string(elements) + " elements: tip off the clamp, m", error,
        reference, 0.05, "error of this element as published, two digits (verification case V2)");
  }
}

}  // namespace
}  // namespace netpocket
