// The forces of cords on a body as the derivative of an energy: weight * depth^2.5 summed over all places of contact.

#include <cmath>
#include <numbers>

#include "engine/dynamics/assembly/dynamic_body.h"
#include "engine/dynamics/contact/contact_search.h"
#include "engine/dynamics/contact/cord_chain.h"
#include "engine/dynamics/system/cable_elements.h"
#include "tests/engine/verification_table.h"

namespace netpocket {
namespace {

using Eigen::Vector3d;

// A cord that hangs down on both sides of x = 0. Each element is bent a little.
class CordOnABody {
 public:
  CordOnABody(const Shape& shape, const Eigen::Quaterniond& attitude, double edge_radius) {
    CableMaterial cord{
        .section = {.EA = 1e4, .EI = 1e-3, .mass_per_length = 1e-3}, .radius = 5e-4, .youngs_modulus = 1e9};
    const std::int32_t material = model_.add_material(cord);
    std::int32_t last = model_.add_node({-1, -height(-1), 0});
    std::int32_t gradient = model_.add_gradient(last, slope(-1));
    for (const double x : {-0.5, 0.0, 0.5, 1.0}) {
      const std::int32_t node = model_.add_node({x, -height(x), 0}), next = model_.add_gradient(node, slope(x));
      model_.add_element({last, gradient, node, next, 0.52, material});
      last = node;
      gradient = next;
    }
    model_.contact.edge_radius = edge_radius;
    ModelBody body{.name = "body", .shape = shape, .mass = 1, .inertia = Eigen::Matrix3d::Identity(), .state = {}};
    body.state.attitude = attitude;
    model_.add_body(body);
  }

  struct Sum {
    double energy = 0;
    Vector3d force = Vector3d::Zero();  // on the body
    std::size_t places = 0;
  };
  Sum with_body_at(const Vector3d& position) const {
    Model model = model_;
    model.bodies[0].state.position = position;
    const CableElements elements(model, ElementEvaluation::mean_strain);
    const CoordinateLayout layout{static_cast<std::int32_t>(model.nodes.size()),
                                  static_cast<std::int32_t>(model.gradients.size())};
    CoordinateVectors coordinates(layout.size());
    for (std::size_t i = 0; i < model.nodes.size(); ++i) {
      coordinates.set(layout.position(static_cast<std::int32_t>(i)), model.nodes[i].position);
    }
    for (std::size_t i = 0; i < model.gradients.size(); ++i) {
      coordinates.set(layout.gradient(static_cast<std::int32_t>(i)), model.gradients[i].value);
    }
    const DynamicBody body(model, 0, layout, elements.mass());
    ContactSearch search(model, next_elements(model), 0);
    std::vector<CordTouch> touches;
    search.find(coordinates, elements.batch(), body, 0, touches);
    Sum sum;
    for (const CordTouch& touch : touches) {
      sum.energy += touch.share * std::pow(touch.penetration, 2.5);
      sum.force -= touch.share * 2.5 * std::pow(touch.penetration, 1.5) * touch.normal;
    }
    sum.places = touches.size();
    return sum;
  }

  // Of the cord below its highest point.
  static double height(double x) { return 0.3 * std::abs(x) + 0.05 * x * x; }

 private:
  static Vector3d slope(double x) { return Vector3d(1, x == 0 ? 0 : -(x > 0 ? 0.3 : -0.3) - 0.1 * x, 0) / 1.04; }

  Model model_;
};

// Largest difference between the force and the slope of the energy, by the largest force, while the body's highest
// point passes along the cord, `depth` (m) above its axis.
double difference_along(const CordOnABody& cord, double top, double depth) {
  constexpr double kStep = 1e-7;
  double largest = 0, difference = 0;
  std::size_t most = 0;
  for (double x = -0.9; x < 0.9; x += 0.0031) {
    const Vector3d place(x, depth - CordOnABody::height(x) - top, 0);
    const CordOnABody::Sum here = cord.with_body_at(place);
    for (const Vector3d& axis : {Vector3d(1, 0, 0), Vector3d(0, 1, 0)}) {
      const double before = cord.with_body_at(place - kStep * axis).energy;
      const double slope = (cord.with_body_at(place + kStep * axis).energy - before) / (2 * kStep);
      difference = std::max(difference, std::abs(slope + here.force.dot(axis)));
    }
    largest = std::max(largest, here.force.norm());
    most = std::max(most, here.places);
  }
  EXPECT_GT(largest, 0);
  EXPECT_GT(most, 1u);
  return difference / largest;
}

class VerificationContactEnergy : public test::VerificationTest {};

TEST_F(VerificationContactEnergy, ForceIsItsSlope) {
  const Eigen::Quaterniond on_edge(Eigen::AngleAxisd(std::numbers::pi / 4, Vector3d::UnitZ()));
  const Eigen::Quaterniond lying(Eigen::AngleAxisd(std::numbers::pi / 2, Vector3d::UnitX()));
  const double half = 0.5 * std::numbers::sqrt2, edge_radius = 5e-3;
  const char* reason = "derivative of an energy without kinks; differences of 0.1 um";
  expect_below(
      "force of a cord on a round edge against the slope of its energy, relative",
      difference_along({Box{{1, 1, 1}}, on_edge, edge_radius}, half - (std::numbers::sqrt2 - 1) * edge_radius, 2.5e-3),
      1e-3, reason);
  expect_below("the same on a sharp edge", difference_along({Box{{1, 1, 1}}, on_edge, 0}, half, -3e-4), 1e-3, reason);
  expect_below("the same on a sphere of 0.3 m",
               difference_along({Sphere{0.3}, Eigen::Quaterniond::Identity(), 0}, 0.3, 4e-3), 1e-3, reason);
  expect_below("the same on a cylinder of 0.2 m", difference_along({Cylinder{0.2, 1}, lying, 0}, 0.2, 4e-3), 1e-3,
               reason);
}

}  // namespace
}  // namespace netpocket
