// V2: statics by dynamic relaxation of the whole system, both evaluations.

#include "tests/engine/dynamics/models.h"
#include "tests/engine/verification_table.h"

namespace netpocket {
namespace {

using namespace test;

// The paper's net cord, 10.5 m between two pins 10 m apart, g = 9.81.
struct CatenaryResult {
  double sag, horizontal;
};

CatenaryResult hang(ElementEvaluation evaluation, int elements) {
  const double span = 10, length = 10.5, depth = 1.4;
  Cable cable = straight_cable(net_cord(), {0, 0, 0}, {span, 0, 0}, elements);
  Model& model = cable.model;
  for (auto& element : model.elements) element.length = length / elements;
  // Begins as a parabola.
  for (int i = 0; i <= elements; ++i) {
    const double x = span * i / elements, slope = -4 * depth / span * (1 - 2 * x / span);
    model.nodes[cable.nodes[i]].position = {x, -4 * depth * x / span * (1 - x / span), 0};
    model.gradients[cable.gradients[i]].value = Eigen::Vector3d(1, slope, 0).normalized();
  }
  for (CableMaterial& material : model.materials) {
    material.section.axial_damping = 1e-4;
    material.section.bending_damping = 1e-2;
  }
  model.fix_node(cable.nodes.front());
  model.fix_node(cable.nodes.back());
  model.gravity = {0, -9.81, 0};
  CableSystem system = relax(model, {.evaluation = evaluation}, evaluation == ElementEvaluation::full ? 1e-6 : 1e-9);
  Snapshot snapshot;
  system.capture(snapshot);
  const int middle = elements / 2;
  // At the lowest point the cord is horizontal: its tension is the horizontal force.
  const double tension =
      0.5 * (snapshot.tension[cable.elements[middle - 1]] + snapshot.tension[cable.elements[middle]]);
  return {-system.position(cable.nodes[middle]).y(), tension};
}

class VerificationStatics : public VerificationTest {};

TEST_F(VerificationStatics, CatenaryByRelaxationMeanStrain) {
  const CatenaryResult result = hang(ElementEvaluation::mean_strain, 32);
  const std::string source =
      "verification case V2: elastic catenary with bending stiffness, pinned; 32 elements, relaxed to 1e-9 J";
  expect_relative("sag, 32 mean-strain elements, m", result.sag, 1.39590, 5e-4, source);
  expect_relative("horizontal force, 32 mean-strain elements, N", result.horizontal, 1.60648, 5e-3, source);
}

TEST_F(VerificationStatics, CatenaryByRelaxationFull) {
  const CatenaryResult result = hang(ElementEvaluation::full, 12);
  const std::string source =
      "verification case V2: elastic catenary with bending stiffness, pinned; 12 elements, relaxed to 1e-6 J";
  expect_relative("sag, 12 full elements, m", result.sag, 1.39590, 2e-3, source);
}

}  // namespace
}  // namespace netpocket
