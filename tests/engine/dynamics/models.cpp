#include "tests/engine/dynamics/models.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "engine/ancf/mass.h"
#include "engine/ancf/strain_pair.h"
#include "engine/ancf/variable_length.h"
#include "engine/dynamics/assembly/consistent_mass.h"
#include "engine/dynamics/ropes/rope_dynamics.h"

namespace netpocket::test {

CableMaterial net_cord() {
  const double d = 0.004, E = 12e9, area = std::numbers::pi * d * d / 4;
  return {.section = {.EA = E * area, .EI = E * std::numbers::pi * std::pow(d, 4) / 64, .mass_per_length = 1430 * area},
          .radius = d / 2,
          .youngs_modulus = E,
          .poisson_ratio = 0.3};
}

CableMaterial plain_cable(double EA, double EI, double mass_per_length) {
  return {.section = {.EA = EA, .EI = EI, .mass_per_length = mass_per_length}};
}

Cable straight_cable(const CableMaterial& material, const Eigen::Vector3d& begin, const Eigen::Vector3d& end,
                     int elements) {
  Cable cable;
  const auto first = cable.model.add_node(begin), last = cable.model.add_node(end);
  cable.elements = cable.model.add_straight_cable(first, last, elements, cable.model.add_material(material));
  for (const auto element : cable.elements) {
    cable.nodes.push_back(cable.model.elements[element].node1);
    cable.gradients.push_back(cable.model.elements[element].gradient1);
  }
  cable.nodes.push_back(last);
  cable.gradients.push_back(cable.model.elements[cable.elements.back()].gradient2);
  return cable;
}

void advance(CableSystem& system, double time, double largest) {
  const double span = time - system.time();
  const int steps = std::max(1, static_cast<int>(std::ceil(span / largest - 1e-9)));
  for (int i = 0; i < steps; ++i) system.step(span / steps);
}

CableSystem relax(const Model& model, const SystemOptions& options, double kinetic_energy, int restarts) {
  Model present = model;
  for (int restart = 0;; ++restart) {
    CableSystem system(present, options);
    const double dt = 0.8 * system.stable_step().step;
    double peak = 0;
    while (true) {
      for (int i = 0; i < 20; ++i) system.step(dt);
      const double kinetic = system.audit().kinetic;
      if (kinetic < peak) break;
      peak = kinetic;
    }
    if (peak < kinetic_energy || restart == restarts) return system;
    for (std::size_t i = 0; i < present.nodes.size(); ++i) {
      present.nodes[i].position = system.position(static_cast<std::int32_t>(i));
    }
    for (std::size_t i = 0; i < present.gradients.size(); ++i) {
      present.gradients[i].value = system.gradient(static_cast<std::int32_t>(i));
    }
  }
}

double total_mass(const Model& model) {
  double mass = model.cable_mass();
  for (const ModelBody& body : model.bodies) mass += body.mass;
  return mass;
}

namespace {

// Positions and gradients of a system at one moment.
struct Coordinates {
  explicit Coordinates(const CableSystem& system) {
    const Model& model = system.model();
    for (std::size_t i = 0; i < model.nodes.size(); ++i) node.push_back(system.position(static_cast<int>(i)));
    for (std::size_t i = 0; i < model.gradients.size(); ++i) gradient.push_back(system.gradient(static_cast<int>(i)));
  }
  std::vector<Eigen::Vector3d> node, gradient;
};

std::vector<Eigen::Vector3d> node_velocities(const CableSystem& system) {
  std::vector<Eigen::Vector3d> velocities;
  for (std::size_t i = 0; i < system.model().nodes.size(); ++i)
    velocities.push_back(system.velocity(static_cast<int>(i)));
  return velocities;
}

void add(Momentum& sum, const Eigen::Vector3d& arm, const Eigen::Vector3d& momentum, bool carries_linear) {
  sum.angular += arm.cross(momentum);
  sum.angular_scale += arm.norm() * momentum.norm();
  if (!carries_linear) return;
  sum.linear += momentum;
  sum.linear_scale += momentum.norm();
}

}  // namespace

Momentum step_and_measure_momentum(CableSystem& system, double dt, ElementEvaluation evaluation) {
  const Model& model = system.model();
  const Coordinates before(system);
  std::vector<RopeMotion> ropes;
  for (std::size_t r = 0; r < model.ropes.size(); ++r) ropes.push_back(system.rope_motion(static_cast<int>(r)));
  system.step(dt);
  const Coordinates now(system);

  Coordinates rate = now;
  for (std::size_t i = 0; i < now.node.size(); ++i) {
    const bool attached = model.nodes[i].support == Support::body;
    rate.node[i] = attached ? system.velocity(static_cast<int>(i)) : (now.node[i] - before.node[i]) / dt;
  }
  for (std::size_t i = 0; i < now.gradient.size(); ++i) {
    const bool attached = model.gradients[i].support == Support::body;
    rate.gradient[i] = attached ? system.body(model.gradients[i].body).angular_velocity.cross(now.gradient[i])
                                : (now.gradient[i] - before.gradient[i]) / dt;
  }

  // Masses of the step, and the momentum of the material that flows past the ropes' nodes, are those at its start.
  std::vector<std::uint8_t> on_rope(model.elements.size(), 0);
  std::vector<double> length;
  for (const ModelElement& element : model.elements) length.push_back(element.length);
  Momentum sum;
  const auto add_node = [&](std::int32_t node, double mass) { add(sum, now.node[node], mass * rate.node[node], true); };
  for (std::size_t r = 0; r < model.ropes.size(); ++r) {
    const VariableRope& rope = model.ropes[r];
    const double mass_per_length = model.material_of(rope.elements.front()).section.mass_per_length;
    for (std::size_t i = 0; i < rope.elements.size(); ++i) {
      const ModelElement& e = model.elements[rope.elements[i]];
      length[rope.elements[i]] = ropes[r].length / static_cast<double>(rope.elements.size());
      on_rope[rope.elements[i]] = 1;
      ElementCoordinates q = ElementCoordinates::Zero();
      q.col(0) = before.node[e.node1];
      q.col(2) = before.node[e.node2];
      const ElementCoordinates flow =
          flow_momentum(mass_per_length, rope_span(ropes[r], rope.share_at_start, i, rope.elements.size()), q);
      add(sum, now.node[e.node1], flow.col(0), true);
      add(sum, now.node[e.node2], flow.col(2), true);
    }
    const double wound = mass_per_length * (rope.motion.length - ropes[r].length);
    add_node(model.elements[rope.elements.front()].node1, rope.share_at_start * wound);
    add_node(model.elements[rope.elements.back()].node2, (1 - rope.share_at_start) * wound);
  }
  const std::vector<std::uint8_t> lumped = lumped_elements(model);
  for (std::size_t i = 0; i < model.elements.size(); ++i) {
    const ModelElement& e = model.elements[i];
    const double mass_per_length = model.materials[e.material].section.mass_per_length;
    NodalWeights lump = lumped_mass(mass_per_length, length[i]);
    if (e.strain_partner >= 0 && evaluation == ElementEvaluation::mean_strain && on_rope[i] == 0) {
      move_from_middle(lump, e.node2 == model.elements[e.strain_partner].node1);
    }
    Eigen::Matrix4d mass = lump.asDiagonal();
    if (evaluation == ElementEvaluation::full && lumped[i] == 0) mass = consistent_mass(mass_per_length, length[i]);
    ElementCoordinates q, velocity;
    q << now.node[e.node1], now.gradient[e.gradient1], now.node[e.node2], now.gradient[e.gradient2];
    velocity << rate.node[e.node1], rate.gradient[e.gradient1], rate.node[e.node2], rate.gradient[e.gradient2];
    const ElementCoordinates momentum = velocity * mass;  // the mass matrix is symmetric
    for (int corner = 0; corner < 4; ++corner) add(sum, q.col(corner), momentum.col(corner), corner % 2 == 0);
  }
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    add_node(static_cast<std::int32_t>(i), model.nodes[i].point_mass);
  }
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const BodyState state = system.body(static_cast<int>(b));
    add(sum, state.position, model.bodies[b].mass * state.velocity, true);
    const Eigen::Matrix3d rotation = state.attitude.toRotationMatrix();
    const Eigen::Vector3d spin = rotation * model.bodies[b].inertia * rotation.transpose() * state.angular_velocity;
    sum.angular += spin;
    sum.angular_scale += spin.norm();
  }
  return sum;
}

MomentumDrift run_and_measure_drift(CableSystem& system, double time, double largest, ElementEvaluation evaluation) {
  const double span = time - system.time();
  const int steps = static_cast<int>(std::ceil(span / largest));
  const Momentum start = step_and_measure_momentum(system, span / steps, evaluation);
  const std::vector<Eigen::Vector3d> before = node_velocities(system);
  for (int i = 2; i < steps; ++i) system.step(span / steps);
  const Momentum end = step_and_measure_momentum(system, span / steps, evaluation);
  // What does not move keeps its momentum as well: the parts must have exchanged theirs.
  const std::vector<Eigen::Vector3d> after = node_velocities(system);
  double changed = 0, fastest = 0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    changed = std::max(changed, (after[i] - before[i]).norm());
    fastest = std::max(fastest, before[i].norm());
  }
  EXPECT_GT(changed, 0.1 * fastest) << "hardly any force acted";
  EXPECT_GT(end.linear_scale, 0) << "nothing moves";
  return {(end.linear - start.linear).norm() / std::max(start.linear_scale, end.linear_scale),
          (end.angular - start.angular).norm() / std::max(start.angular_scale, end.angular_scale)};
}

}  // namespace netpocket::test
