#pragma once
// The state of a run at one moment, as a plain value. It is the only data that passes from simulation to drawing.
// World frame, SI units. Copyable; each copy belongs to the thread that holds it.

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "engine/state/channels.h"

namespace netpocket {

struct BodyState {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();            // m, centre of mass
  Eigen::Quaterniond attitude = Eigen::Quaterniond::Identity();  // body axes to world axes
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();            // m/s
  Eigen::Vector3d angular_velocity = Eigen::Vector3d::Zero();    // rad/s, world axes
};

struct ContactPoint {
  Eigen::Vector3d position;  // m, on the body's surface
  Eigen::Vector3d force;     // N, on the body
  std::int32_t element;      // touching element, index into Structure::elements; -1: another body touches
  std::int32_t body;         // index into Structure::bodies
};

struct Snapshot {
  double time = 0;                          // s
  std::int64_t step = 0;                    // integration steps so far
  Eigen::Matrix3Xd positions;               // m, one column per node
  Eigen::Matrix3Xd velocities;              // m/s, one column per node
  Eigen::Matrix3Xd gradients;               // dr/dp, one column per gradient
  Eigen::VectorXd tension;                  // N, one per element; negative in compression
  Eigen::VectorXd strain;                   // Green strain (r'.r' - 1)/2, one per element
  std::vector<double> rope_element_length;  // m, current material length of one element of each variable-length rope
  std::vector<BodyState> bodies;            // by Structure::bodies
  std::vector<ContactPoint> contacts;
  std::shared_ptr<const ChannelList> channel_list = known_channels();
  std::vector<double> channels = std::vector<double>(channel_list->size(), 0.0);  // by channel_list

  // Value of a channel; NaN if the run has no such channel.
  double channel(Channel c) const& {
    const auto index = channel_list->find(c);
    return index ? channels[*index] : std::numeric_limits<double>::quiet_NaN();
  }
  // Reference to the value, for writing. Throws std::bad_optional_access if the run has no such channel.
  double& channel(Channel c) & { return channels[channel_list->find(c).value()]; }
};

}  // namespace netpocket
