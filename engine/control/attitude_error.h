#pragma once
// The rotation by which an attitude differs from the wanted one. Pure functions.

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace netpocket {

// Rotation vector (rad) of a rotation: along its axis, as long as its angle. Of the two ways round it is the shorter
// one, so its length is at most pi; at half a turn both are as short, and the sign of `rotation` decides. Its accuracy
// does not fall for small angles: angle = 2 atan2(|v|, |w|) of the quaternion's parts v and w.
Eigen::Vector3d rotation_vector(const Eigen::Quaterniond& rotation);

// Rotation vector (rad, body axes) that turns the attitude `wanted` into `present`. Both turn body axes into world
// axes. Its components are the same in the present and in the wanted body axes.
Eigen::Vector3d attitude_error(const Eigen::Quaterniond& present, const Eigen::Quaterniond& wanted);

}  // namespace netpocket
