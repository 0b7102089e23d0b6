#include "engine/dynamics/system/cable_state.h"

#include <bit>

namespace netpocket {
namespace {

// Visits the numbers of a vector; returns whether a bit of it has changed. 0.0 and -0.0 compare equal, bits do not.
template <typename Vector>
bool visit_changes(Vector&& vector, const std::function<void(double&)>& visit) {
  bool changes = false;
  for (Eigen::Index i = 0; i < vector.size(); ++i) {
    const auto before = std::bit_cast<std::uint64_t>(vector[i]);
    visit(vector[i]);
    changes = changes || std::bit_cast<std::uint64_t>(vector[i]) != before;
  }
  return changes;
}

void visit_vectors(CoordinateVectors& vectors, const std::function<void(double&)>& visit) {
  for (std::int32_t coordinate = 0; coordinate < vectors.size(); ++coordinate) {
    Eigen::Vector3d value = vectors.get(coordinate);
    if (visit_changes(value, visit)) vectors.set(coordinate, value);
  }
}

void visit_body(RigidBody& body, const std::function<void(double&)>& visit) {
  RigidBodyState state = body.state();
  bool changes = visit_changes(state.position, visit);
  changes = visit_changes(state.velocity, visit) || changes;
  changes = visit_changes(state.attitude.coeffs(), visit) || changes;
  changes = visit_changes(state.angular_momentum, visit) || changes;
  if (changes) body.restore(state);
}

}  // namespace

CableState::CableState(const Model& model, std::span<const double> mass)
    : layout(layout_of(model)), coordinates(layout.size()), velocities(layout.size()), controls(model.bodies.size()) {
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    const std::int32_t position = layout.position(static_cast<std::int32_t>(i));
    coordinates.set(position, model.nodes[i].position);
    if (model.nodes[i].support == Support::free) velocities.set(position, model.nodes[i].velocity);
  }
  for (std::size_t i = 0; i < model.gradients.size(); ++i) {
    const std::int32_t gradient = layout.gradient(static_cast<std::int32_t>(i));
    coordinates.set(gradient, model.gradients[i].value);
    if (model.gradients[i].support == Support::free) velocities.set(gradient, model.gradients[i].rate);
  }
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    bodies.emplace_back(model, static_cast<std::int32_t>(b), layout, mass);
    bodies.back().move_attachments(coordinates, velocities);
  }
  for (const BodyLock& lock : model.locks) locks.emplace_back(lock, model, bodies);
}

void CableState::visit_motion(const std::function<void(double&)>& visit) {
  visit_vectors(coordinates, visit);
  visit_vectors(velocities, visit);
  for (DynamicBody& body : bodies) visit_body(body.rigid(), visit);
  for (BodyControl& control : controls) control.visit_state(visit);
  for (LockedBodies& lock : locks) lock.visit_state(visit);
}

void CableState::visit_time(const std::function<void(double&)>& visit) {
  double count = static_cast<double>(steps);
  for (double* value : {&time, &last_step, &count}) visit(*value);
  // A file may hold a number that is not a valid count.
  if (count >= 0 && count < 9e15) steps = static_cast<std::int64_t>(count);
}

}  // namespace netpocket
