#pragma once
// What the controllers of a spacecraft know, through the sensors of a scenario.

#include <Eigen/Core>
#include <vector>

#include "engine/control/sensor_channel.h"
#include "engine/control/visited_numbers.h"
#include "engine/scenario/control_parameters.h"
#include "engine/state/snapshot.h"

namespace netpocket {

struct Observed {
  BodyState craft, target;
  Eigen::Vector3d contact_force = Eigen::Vector3d::Zero();  // N, of cables on the target, world axes
};

// A sensor with as many components as the quantity has.
SensorChannel sensor_channel(const SensorParameters& sensor, std::size_t size);

// The sensors of all quantities but the ropes' tension. The attitude is sensed as rotation vector from world to body
// axes; noise and bias add to it.
class Sensors {
 public:
  explicit Sensors(const std::vector<SensorParameters>& sensors);

  // What is known at `time` (s). Times must not fall.
  Observed look(double time, const Observed& truth);
  void visit_state(const NumberVisitor& visit);

 private:
  struct Entry {
    SensorKind kind;
    SensorChannel channel;
  };
  std::vector<Entry> entries_;
};

}  // namespace netpocket
