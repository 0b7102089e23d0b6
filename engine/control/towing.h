#pragma once
// What drives the spacecraft: towing and station keeping, as the scenario says.

#include <functional>
#include <optional>

#include "engine/control/gradual_change.h"
#include "engine/dynamics/assembly/dynamic_body.h"
#include "engine/scenario/scenario.h"

namespace netpocket {

// Towing along -Y from `start` on, size ramped up smoothly (s - sin(2 pi s)/(2 pi), over a tenth of the duration) so
// that the tow does not begin with a blow:
//   force         thrust `size` (N) for `duration`
//   acceleration  thrust that gives the whole captured system (`total_mass`, kg) the acceleration `size` (m/s^2) for
//                 `duration`
//   velocity      the spacecraft's velocity along Y goes from what it is at `start` to -`size` (m/s) over `duration` by
//                 a cycloid and stays there; the thrust is what that takes
// Thrust acts at `offset` (m) from the axis, `offset_angle` (rad) from the spacecraft's x axis towards its z axis.
// Station keeping holds attitude, or attitude and lateral position, at all times; held attitude takes up the moment of
// the offset.
//
// A change in the midst of a run is no blow. What is prescribed from then on, a velocity or the attitude, starts from
// the present velocity and acceleration and reaches what is asked for within the towing's duration or, for what is
// held, within half a second. What is no longer prescribed, and every other force, goes over from the force and the
// moment that act, within half a second.
class SpacecraftDrive {
 public:
  SpacecraftDrive(const TowingParameters& towing, StationKeeping station_keeping, double total_mass);

  // Changes what will be done from `now` (s) on.
  void change(const TowingParameters& towing, StationKeeping station_keeping, double now);

  // Control at `time` (s); `craft`: the motion of the spacecraft and what is attached to it now.
  BodyControl at(double time, const RigidMotion& craft);
  // After the step of `dt` (s) with that control: what the control exerted in it, and the motion now.
  void note_step(const Wrench& exerted, const RigidMotion& craft, double dt);

  void visit_state(const std::function<void(double&)>& visit);

 private:
  // A velocity or angular velocity that is prescribed. World axes.
  struct Guide {
    double begin = -1;  // s; negative: it is not prescribed
    Eigen::Vector3d rate = Eigen::Vector3d::Zero();
    Eigen::Vector3d acceleration = Eigen::Vector3d::Zero();  // both at the beginning

    bool is_on() const { return begin >= 0; }
    void turn_on(double since, const Eigen::Vector3d& rate_then, const Eigen::Vector3d& acceleration_then);
    // `progress`: part of the way from the rate at the beginning to the one wanted.
    double at(int axis, double time, double wanted, double progress) const;
  };

  bool pulls(double time) const { return towing_.mode != TowingMode::none && time >= towing_.start; }
  double thrust(double elapsed) const;
  Wrench acting() const;
  void hold(double time, const RigidMotion& craft, BodyControl& control);
  void tow(double time, const RigidMotion& craft, BodyControl& control);

  TowingParameters towing_;
  StationKeeping station_keeping_;
  double total_mass_;
  double changed_ = -kChangeDuration;  // s, when `released_` acted
  Wrench released_;                    // goes to nothing from then on, while what is asked for grows
  Guide tow_, lateral_, attitude_;
  // Of the last step, and means over the last kMemory or so, without which the blow of a contact would be taken for
  // the motion.
  Wrench exerted_, mean_exerted_;
  Eigen::Vector3d mean_acceleration_ = Eigen::Vector3d::Zero();          // m/s^2
  Eigen::Vector3d mean_angular_acceleration_ = Eigen::Vector3d::Zero();  // rad/s^2
  RigidMotion before_;                                                   // the step
  double last_step_ = 0;                                                 // s
};

}  // namespace netpocket
