#pragma once
// What drives the spacecraft: towing and station keeping, as the scenario says.

#include <functional>

#include "engine/dynamics/dynamic_body.h"
#include "engine/scenario/scenario.h"

namespace netpocket {

// Towing along -Y from `start` on, size ramped up smoothly (s - sin(2 pi s)/(2 pi), over a tenth of the duration) so
// that the tow does not begin with a blow:
//   force         thrust `size` (N) for `duration`
//   acceleration  thrust that gives the whole captured system (`total_mass`, kg) the acceleration `size` (m/s^2) for
//                 `duration`
//   velocity      the spacecraft's velocity along Y goes from what it is at `start` to -`size` (m/s) over `duration` by
//   a
//                 cycloid and stays there; the thrust is what that takes
// Thrust acts at `offset` (m) from the axis, `offset_angle` (rad) from the spacecraft's x axis towards its z axis.
// Station keeping holds attitude, or attitude and lateral position, at all times; held attitude takes up the moment of
// the offset.
class SpacecraftDrive {
 public:
  SpacecraftDrive(const TowingParameters& towing, StationKeeping station_keeping, double total_mass);

  // Changes what will be done from now on.
  void change(const TowingParameters& towing, StationKeeping station_keeping);
  void visit_state(const std::function<void(double&)>& visit) { visit(velocity_at_start_); }

  // Control at `time` (s); `velocity_y` (m/s) is the spacecraft's now.
  BodyControl at(double time, double velocity_y);

 private:
  TowingParameters towing_;
  StationKeeping station_keeping_;
  double total_mass_;
  double velocity_at_start_ = 0;
};

}  // namespace netpocket
