#include "engine/dynamics/system/travelled_way.h"

#include <algorithm>
#include <cmath>

namespace netpocket {

TravelledWay::TravelledWay(const Model& model, const CableElements& elements, const CableState& state,
                           const SystemThreads& threads)
    : model_(model),
      elements_(elements),
      state_(state),
      threads_(threads),
      bound_(model),
      bodies_(state.bodies.size(), 0.0),
      noted_rope_length_(model.ropes.size(), 0.0) {
  for (const DynamicBody& body : state.bodies) attachments_reach_.push_back(reach_of_attachments(body));
}

// Largest distance (m) that a point of a cord moves per radian of the body's rotation: the farthest attached node, plus
// the effect of a rotating attached gradient on the curve, at most a quarter of the longest element times the gradient.
double TravelledWay::reach_of_attachments(const DynamicBody& body) const {
  double longest = 0, farthest = 0, steepest = 0;
  for (const double length : elements_.lengths()) longest = std::max(longest, length);
  for (const DynamicBody::Attachment& attachment : body.attachments()) {
    double& largest = attachment.direction ? steepest : farthest;
    largest = std::max(largest, attachment.local.norm());
  }
  return farthest + 0.25 * longest * steepest;
}

double TravelledWay::cord_speed() {
  if (version_ != state_.version) cord_speed_ = bound_.speed(state_.velocities, threads_.loop());
  version_ = state_.version;
  return cord_speed_;
}

TravelledWay::Pose TravelledWay::pose_of(const DynamicBody& body) {
  return {body.centre(), body.rigid().position(), body.rigid().attitude()};
}

// Between two poses, a point at distance a from the centre moves by at most the centre's displacement plus the chord of
// the rotation, 2 a sin(angle/2).
void TravelledWay::note_body(std::size_t body, const Pose& before) {
  const DynamicBody& moved = state_.bodies[body];
  const double chord = 2 * (before.attitude.conjugate() * moved.rigid().attitude()).vec().norm();
  bodies_[body] += (moved.centre() - before.centre).norm() + chord * bounding_radius(model_.bodies[body].shape);
  if (!moved.attachments().empty()) {
    cords_ += (moved.rigid().position() - before.position).norm() + chord * attachments_reach_[body];
  }
}

// From the largest speeds that the step has found, the bound needs no further look at the velocities. Attached points
// follow from the bodies.
void TravelledWay::note_step(double dt, const std::optional<update_kernel::Fastest>& fastest) {
  if (fastest) {
    cord_speed_ = MotionBound::speed(fastest->position, fastest->gradient);
    for (std::size_t b = 0; b < state_.bodies.size(); ++b) {
      if (state_.bodies[b].attachments().empty()) continue;
      const RigidBody& body = state_.bodies[b].rigid();
      cord_speed_ =
          larger_or_none(cord_speed_, body.velocity().norm() + body.angular_velocity().norm() * attachments_reach_[b]);
    }
    version_ = state_.version;
  }
  cords_ += dt * cord_speed();  // of free coordinates; note_body adds that of attachments
}

// If an element's length changes by d, its curve moves by another |d| |S_2 + S_4|/L <= |d|/4 at most.
TravelledWay::Ways TravelledWay::take() {
  const RopeDynamics& ropes = elements_.ropes();
  double shortened = 0;
  for (std::int32_t rope = 0; rope < ropes.rope_count(); ++rope) {
    double& noted = noted_rope_length_[static_cast<std::size_t>(rope)];
    shortened = std::max(shortened, std::abs(ropes.element_length(rope) - noted));
    noted = ropes.element_length(rope);
  }
  constexpr double kRounding = 1 + 1e-9;
  Ways ways{kRounding * (cords_ + 0.25 * shortened), bodies_};
  for (double& body : ways.bodies) body *= kRounding;
  cords_ = 0;
  std::ranges::fill(bodies_, 0.0);
  return ways;
}

}  // namespace netpocket
