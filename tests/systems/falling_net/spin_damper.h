#pragma once
// A sampled controller of ten lines: a torque against the spin of a body.

#include "engine/control/controller.h"
#include "engine/control/gradual_change.h"
#include "engine/scenario/parameters.h"

namespace netpocket {

class SpinDamper : public Controller {
 public:
  // `damping`: N m s.
  SpinDamper(std::int32_t body, double damping) : body_(body), damping_(damping) {}

  void update(const Measurements& measurements, double /*interval*/, Commands& commands) override {
    const double damping = damping_.at(measurements.time());
    commands.body(body_).at_centre.torque = -damping * measurements.motion(body_).angular_velocity;
  }
  void change(const Scenario& scenario, double now) override {
    const Parameter* parameter = find_parameter("falling_net.spin_damping", scenario.system);
    damping_.change(std::get<double>(parameter->get(scenario)), now);
  }
  void visit_state(const std::function<void(double&)>& visit) override { damping_.visit_state(visit); }

 private:
  std::int32_t body_;
  GradualChange damping_;
};

}  // namespace netpocket
