#include "engine/control/tracking_error.h"

#include "engine/control/attitude_error.h"
#include "engine/math/symmetric_algebra.h"

namespace netpocket {

TrackingError position_error(const BodyState& present, const BodyState& wanted) {
  return {present.position - wanted.position, present.velocity - wanted.velocity};
}

TrackingError rotation_error(const BodyState& present, const BodyState& wanted) {
  return {attitude_error(present.attitude, wanted.attitude),
          to_body_axes(present, present.angular_velocity - wanted.angular_velocity)};
}

Eigen::Vector3d to_body_axes(const BodyState& body, const Eigen::Vector3d& world) {
  return symmetric_transposed_product(body.attitude.toRotationMatrix(), world);
}

Eigen::Vector3d to_world_axes(const BodyState& body, const Eigen::Vector3d& local) {
  return symmetric_product(body.attitude.toRotationMatrix(), local);
}

}  // namespace netpocket
