// Inflated rods of a whole system: deflection beyond wrinkling, energy, change of pressure.

#include <array>

#include "engine/ancf/wrinkling.h"
#include "tests/engine/dynamics/models.h"
#include "tests/engine/verification_table.h"

namespace netpocket {
namespace {

using namespace test;

class VerificationInflatedRod : public VerificationTest {};

constexpr double kLength = 1, kEI = 100, kMoment = 2;

// A cantilever that wrinkles at 2 N m, loaded across its tip.
Cable inflated_cantilever(double force, int elements) {
  CableMaterial rod = plain_cable(1e5, kEI, 0.5);
  rod.section.bending_damping = 2e-3;
  rod.wrinkling_moment = kMoment;
  Cable cable = straight_cable(rod, {0, 0, 0}, {kLength, 0, 0}, elements);
  for (CableMaterial& material : cable.model.materials) material.is_tube = true;
  cable.model.fix_node(cable.nodes.front());
  cable.model.fix_gradient(cable.gradients.front());
  cable.model.nodes[cable.nodes.back()].load = {0, force, 0};
  return cable;
}

// Curvature over M_w/EI at which the tube carries `moment` (of M_w), by bisection.
double curvature_at(double moment) {
  double low = 0, high = 1e3;
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (low + high);
    (InflatedBending(middle).moment < moment ? low : high) = middle;
  }
  return low;
}

// Deflection of the tip by beam theory: int kappa(M(x)) (L - x) dx with M = F (L - x).
double beam_deflection(double force) {
  const int points = 4000;
  double sum = 0;
  for (int i = 0; i < points; ++i) {
    const double arm = kLength * (i + 0.5) / points;
    sum += curvature_at(force * arm / kMoment) * kMoment / kEI * arm * kLength / points;
  }
  return sum;
}

constexpr std::array<std::pair<ElementEvaluation, const char*>, 2> kBothEvaluations = {
    {{ElementEvaluation::mean_strain, "mean-strain"}, {ElementEvaluation::full, "full"}}};

TEST_F(VerificationInflatedRod, DeflectionBeyondWrinkling) {
  for (const auto& [evaluation, name] : kBothEvaluations) {
    // The full evaluation converges faster and needs smaller steps.
    const int elements = evaluation == ElementEvaluation::full ? 4 : 12;
    for (const double force : {1.8, 3.0}) {
      const Cable cable = inflated_cantilever(force, elements);
      const CableSystem system = relax(cable.model, {.evaluation = evaluation}, 1e-10);
      expect_relative("tip of an inflated cantilever under " + std::to_string(force / kMoment).substr(0, 3) +
                          " times its wrinkling load, m, " + name,
                      system.position(cable.nodes.back()).y(), beam_deflection(force), 1e-2,
                      "small deflections of a beam of Comer & Levy's law, by quadrature; " + std::to_string(elements) +
                          " elements");
    }
  }
}

TEST_F(VerificationInflatedRod, EnergyOfAReleaseAndOfALossOfPressure) {
  for (const auto& [evaluation, name] : kBothEvaluations) {
    Cable cable = inflated_cantilever(1.6, 12);
    cable.model.materials[0].section.bending_damping = 0;
    CableSystem system(cable.model, {.evaluation = evaluation});
    const double dt = 0.4 * system.stable_step().step;
    advance(system, 0.3, dt);
    const EnergyAudit swinging = system.audit();
    const double scale = swinging.kinetic + swinging.strain;
    expect_below(std::string("inflated rod swinging beyond wrinkling: energy error / energy, ") + name,
                 std::abs(swinging.error) / scale, 1e-3,
                 "no damping: leapfrog's bounded error; the softened law is a potential");
    const double before = system.position(cable.nodes.back()).y();
    system.set_wrinkling_moment(0, kMoment / 3);
    advance(system, 0.6, dt);
    const EnergyAudit sunk = system.audit();
    expect_below(std::string("rod that loses two thirds of its pressure: energy error / energy, ") + name,
                 std::abs(sunk.error) / scale, 2e-2,
                 "the change of energy at the change of pressure is booked as work");
    EXPECT_GT(system.position(cable.nodes.back()).y(), before + 0.01) << "it cannot carry the load any more";
  }
}

}  // namespace
}  // namespace netpocket
