#pragma once
// Controls the spacecraft: towing and station keeping as the scenario describes them.

#include <functional>
#include <memory>
#include <optional>

#include "engine/control/capture_times.h"
#include "engine/control/controller.h"
#include "engine/control/gradual_change.h"
#include "engine/dynamics/assembly/dynamic_body.h"
#include "engine/orbit/reference_orbit.h"
#include "engine/scenario/scenario.h"

namespace netpocket {

// Towing along -Y from `start` (s) on. In the modes `force` and `acceleration` the thrust rises and falls smoothly, as
// s - sin(2 pi s)/(2 pi) over a tenth of the duration, so that no blow occurs. Modes:
//   force         thrust `size` (N) for `duration` (s)
//   acceleration  thrust that gives the whole captured system (`total_mass`, kg) the acceleration `size` (m/s^2) for
//                 `duration`
//   velocity      the spacecraft's velocity along Y goes from its value at `start` to -`size` (m/s) over `duration` by
//                 a cycloid and stays there; the thrust is what this requires
//   controlled    none: a controller pulls (closed_loop.h)
// The thrust acts at `offset` (m) from the axis, at `offset_angle` (rad) from the spacecraft's x axis towards its z
// axis. Station keeping holds the attitude, or the attitude and the lateral position, at all times. A held attitude
// takes up the moment of the offset thrust.
//
// In an orbit whose local axes the drive follows, the thrust along -Y turns with them, and so does a held attitude.
//
// Changes during a run cause no blow. A motion that becomes prescribed (velocity, attitude) starts from the present
// velocity and acceleration. It reaches the wanted value within the towing's duration or, if it is held, within 0.5 s.
// A motion that is no longer prescribed, and every other force, changes from the present force and moment within 0.5 s.
class SpacecraftDrive : public Controller {
 public:
  // `total_mass`: kg. `spacecraft`: index of the body. `times`: their start of the towing, which may be infinite at
  // first, takes the place of the scenario's, and at their end the towing ceases; null: the scenario's time.
  SpacecraftDrive(const TowingParameters& towing, StationKeeping station_keeping, double total_mass,
                  std::int32_t spacecraft = 0, std::shared_ptr<const CaptureTimes> times = nullptr);

  // Follows the local axes of this orbit (orbit/reference_orbit.h) from now on.
  void follow(const Orbit& orbit);

  void update(const Measurements& measurements, double interval, Commands& commands) override;
  void after_step(const Measurements& measurements, double dt) override;
  void change(const Scenario& scenario, double now) override;
  void visit_state(const std::function<void(double&)>& visit) override;

  // Changes the control from `now` (s) on.
  void change(const TowingParameters& towing, StationKeeping station_keeping, double now);

  // Control at `time` (s). `craft`: present motion of the spacecraft with what is attached to it.
  BodyControl at(double time, const RigidMotion& craft);
  // To be called after the step of `dt` (s) with that control. `exerted`: what the control exerted in the step;
  // `craft`: the present motion.
  void note_step(const Wrench& exerted, const RigidMotion& craft, double dt);

 private:
  // A prescribed velocity or angular velocity, in world axes.
  struct Guide {
    double begin = -1;  // s; negative: not prescribed
    Eigen::Vector3d rate = Eigen::Vector3d::Zero();
    Eigen::Vector3d acceleration = Eigen::Vector3d::Zero();  // rate and acceleration at `begin`

    bool is_on() const { return begin >= 0; }
    void turn_on(double since, const Eigen::Vector3d& rate_then, const Eigen::Vector3d& acceleration_then);
    // Component `axis` of the rate at `time` (s). `progress`: fraction of the way from `rate` to `wanted`.
    double at(int axis, double time, double wanted, double progress) const;
  };

  bool pulls(double time) const {
    return towing_.mode != TowingMode::none && towing_.mode != TowingMode::controlled && time >= towing_.start;
  }
  TowingParameters with_times(TowingParameters towing, double now) const;
  void follow_times(double now);
  double thrust(double elapsed) const;
  Wrench acting() const;
  void hold(double time, const RigidMotion& craft, BodyControl& control);
  void tow(double time, const RigidMotion& craft, BodyControl& control);

  TowingParameters given_;   // by the scenario
  TowingParameters towing_;  // with the times of the events
  StationKeeping station_keeping_;
  double total_mass_;
  std::int32_t spacecraft_;
  std::shared_ptr<const CaptureTimes> times_;
  std::optional<ReferenceOrbit> orbit_;                       // if its local axes are followed
  Eigen::Matrix3d first_axes_ = Eigen::Matrix3d::Identity();  // the local axes at the start
  double changed_ = -kChangeDuration;                         // s, time of the last change
  Wrench released_;  // acted at changed_; fades to zero while the new control grows
  Guide tow_, lateral_, attitude_;
  // exerted_ is of the last step. The others are means over about kMemory: a single step would take the blow of a
  // contact for the motion.
  Wrench exerted_, mean_exerted_;
  Eigen::Vector3d mean_acceleration_ = Eigen::Vector3d::Zero();          // m/s^2
  Eigen::Vector3d mean_angular_acceleration_ = Eigen::Vector3d::Zero();  // rad/s^2
  RigidMotion before_;                                                   // at the beginning of the step
  double last_step_ = 0;                                                 // s
};

}  // namespace netpocket
