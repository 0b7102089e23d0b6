#include "engine/scenario/check_overlaps.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>

#include "engine/math/rotation.h"
#include "engine/scenario/pocket_outline.h"

namespace netpocket {
namespace {

constexpr int kSamples = 40;  // intervals along each edge of a sampled surface

// Signed distance (m) of a world point from a body's surface, negative inside. Exact inside and near faces; a lower
// bound elsewhere.
using Distance = std::function<double(const Eigen::Vector3d&)>;

Distance distance_from_target(const TargetParameters& target, const Shape& shape) {
  const Eigen::Matrix3d to_body = rotation_by(target.attitude).toRotationMatrix().transpose();
  const double radius = bounding_radius(shape);
  return [target, &shape, radius, to_body](const Eigen::Vector3d& point) {
    const Eigen::Vector3d arm = point - target.position;
    const double least = arm.norm() - radius;
    constexpr double kFar = 1.0;  // m, beyond which the distance need not be exact
    return least > kFar ? least : nearest_surface_point(shape, to_body * arm).distance;
  };
}

Distance distance_from_spacecraft(const SpacecraftParameters& spacecraft) {
  return [spacecraft](const Eigen::Vector3d& point) {
    return ((point - spacecraft.position).cwiseAbs() - spacecraft.size / 2).maxCoeff();
  };
}

// The point of a surface that is deepest inside a body, or nearest to it.
struct Deepest {
  double distance = HUGE_VAL;  // m
  Eigen::Vector3d point{0, 0, 0};

  void visit(const Eigen::Vector3d& candidate, double candidate_distance) {
    if (candidate_distance < distance) {
      distance = candidate_distance;
      point = candidate;
    }
  }
};

// Deepest point of the pocket's rods and panels in a body. Accounts for the radii of rods and cords.
Deepest deepest_in_pocket(const Scenario& scenario, const Distance& distance, double rod_radius, double cord_radius) {
  Deepest deepest;
  for (const PanelOutline& panel : panel_outlines(scenario)) {
    for (int i = 0; i <= kSamples; ++i) {
      const double radius = i == 0 || i == kSamples ? rod_radius : cord_radius;
      for (int j = 0; j <= kSamples; ++j) {
        const Eigen::Vector3d point = panel.point(double(i) / kSamples, double(j) / kSamples);
        deepest.visit(point, distance(point) - radius);
      }
    }
  }
  return deepest;
}

// Deepest point of the spacecraft's bus in a body, including its interior.
Deepest deepest_in_bus(const SpacecraftParameters& spacecraft, const Distance& distance) {
  Deepest deepest;
  const Eigen::Vector3d corner = spacecraft.position - spacecraft.size / 2;
  for (int i = 0; i <= kSamples; ++i) {
    for (int j = 0; j <= kSamples; ++j) {
      for (int k = 0; k <= kSamples; ++k) {
        const Eigen::Vector3d point = corner + spacecraft.size.cwiseProduct(Eigen::Vector3d(i, j, k)) / kSamples;
        deepest.visit(point, distance(point));
      }
    }
  }
  return deepest;
}

std::string place(const Deepest& deepest) {
  const Eigen::Vector3d& p = deepest.point;
  return fmt::format("by {:.3g} m at ({:.3g}, {:.3g}, {:.3g}) m", -deepest.distance, p.x(), p.y(), p.z());
}

}  // namespace

void check_overlaps(const Scenario& scenario, const Shape& target_shape, Diagnostics& diagnostics) {
  const Distance target = distance_from_target(scenario.target, target_shape);
  const Distance spacecraft = distance_from_spacecraft(scenario.spacecraft);

  const auto net_in_target =
      deepest_in_pocket(scenario, target, scenario.rods.outer_diameter / 2, scenario.net.diameter / 2);
  if (net_in_target.distance < 0) {
    diagnostics.add(
        {.key = "target.position",
         .message = "the target starts inside the net: it overlaps a panel or rod " + place(net_in_target)});
  }

  auto bus_in_target = deepest_in_bus(scenario.spacecraft, target);
  bus_in_target.visit(scenario.target.position, spacecraft(scenario.target.position));
  if (bus_in_target.distance < 0) {
    diagnostics.add({.key = "target.position",
                     .message = "the target starts inside the spacecraft: they overlap " + place(bus_in_target)});
  }

  // The rods are clamped to the bus, so the net may touch its surface.
  constexpr double kTouching = 1e-6;  // m
  const auto net_in_bus = deepest_in_pocket(scenario, spacecraft, 0, 0);
  if (net_in_bus.distance < -kTouching) {
    diagnostics.add(
        {.key = "spacecraft.position",
         .message = "the spacecraft's bus reaches into the pocket: it overlaps a panel or rod " + place(net_in_bus)});
  }
}

}  // namespace netpocket
