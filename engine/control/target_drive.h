#pragma once
// A target that acts: thrust through its centre of mass and torque of its own, both fixed to its axes, between two
// times.

#include "engine/control/controller.h"
#include "engine/scenario/scenario.h"

namespace netpocket {

class TargetDrive : public Controller {
 public:
  // `body`: index of the target.
  TargetDrive(const TargetParameters& target, std::int32_t body) : target_(target), body_(body) {}

  void update(const Measurements& measurements, double interval, Commands& commands) override;
  void change(const Scenario& scenario, double now) override;
  void visit_state(const std::function<void(double&)>& visit) override;

 private:
  TargetParameters target_;
  std::int32_t body_;
};

}  // namespace netpocket
