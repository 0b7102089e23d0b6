#pragma once
// The controllers of a spacecraft as a scenario lists them, with the sensors before them and the actuators behind.
//
// Each controller samples at its own rate what the sensors know, and its demand is held in between. The sum of the
// demands goes to the actuators at the highest of these rates. A controller outside its phase demands nothing.
//
// When gains or set points are changed during a run, the law keeps its state, and the jump of its demand fades within
// 0.5 s. World frame, SI units. Thread contract: the thread of the run.

#include <memory>
#include <vector>

#include "engine/control/actuator_set.h"
#include "engine/control/capture_times.h"
#include "engine/control/contact_force.h"
#include "engine/control/control_law.h"
#include "engine/control/controller.h"
#include "engine/control/observed.h"
#include "engine/control/sample_clock.h"
#include "engine/state/control_loop_info.h"

namespace netpocket {

class ClosedLoop : public Controller {
 public:
  // The scenario must pass check_scenario and have at least one controller. `spacecraft`, `target`: indices of bodies.
  ClosedLoop(const Scenario& scenario, const ControlledCraft& craft, std::shared_ptr<const CaptureTimes> times,
             std::int32_t spacecraft, std::int32_t target);

  void update(const Measurements& measurements, double interval, Commands& commands) override;
  void after_step(const Measurements& measurements, double dt) override;
  void change(const Scenario& scenario, double now) override;
  void visit_state(const std::function<void(double&)>& visit) override;

  // What the actuators were last asked for and what they exerted on average since the last call, world axes.
  struct Effort {
    Wrench demanded, exerted;
  };
  Effort take_effort(double time);
  // Sum of the estimates of all observers: force in world axes, torque in body axes.
  Wrench disturbance() const;
  bool has_observer() const;
  // What one of the controllers, in the order of the scenario, does at `time` (s), by the true state of the bodies.
  struct View {
    LoopState state;
    Tracking tracking;
    Wrench demand;  // world axes
  };
  View view(std::size_t controller, const BodyState& craft, const BodyState& target, double time) const;
  const ActuatorSet& actuators() const { return actuators_; }

 private:
  struct Entry {
    ControllerParameters parameters;
    std::unique_ptr<ControlLaw> law;
    SampleClock clock;
    bool acts = false;          // whether it was in its phase at the last sample
    double last_sample = 0;     // s
    Wrench demand = {};         // held
    Wrench impulse = {};        // N s, N m s, exerted since the last sample
    double changed = -1;        // s, time of the last change; negative: never
    bool jump_is_known = true;  // of the demand at that change
    Wrench jump = {};           // fades
  };
  void sample(Entry& entry, const Observed& observed, double now);
  void command(const Observed& observed);

  ControlledCraft craft_;
  std::shared_ptr<const CaptureTimes> times_;
  std::int32_t spacecraft_, target_;
  Sensors sensors_;
  ContactForce contact_;
  std::vector<Entry> entries_;
  SampleClock clock_;  // of the actuators
  ActuatorSet actuators_;
  Wrench demanded_;
  Wrench impulse_;          // N s, N m s, exerted since effort_time_
  double effort_time_ = 0;  // s
};

}  // namespace netpocket
