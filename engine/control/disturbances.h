#pragma once
// Forces and torques that act on the spacecraft or on the target for a while, as the scenario lists them.
//
// A step that a disturbance covers in part has that part of its wrench, so that its impulse does not depend on the
// steps. A list that changes during a run acts from then on. World frame, SI units. Thread contract: the thread of the
// run.

#include <array>
#include <vector>

#include "engine/control/controller.h"

namespace netpocket {

class Disturbances : public Controller {
 public:
  // Indices of bodies.
  Disturbances(const std::vector<DisturbanceParameters>& list, std::int32_t spacecraft, std::int32_t target)
      : list_(list), bodies_{{{spacecraft}, {target}}} {}

  void update(const Measurements& measurements, double interval, Commands& commands) override;
  void change(const Scenario& scenario, double now) override;
  void visit_state(const std::function<void(double&)>& visit) override;

  // Wrench on a body on average since the last call, world axes.
  Wrench take_mean(DisturbedBody body, double time);

 private:
  struct Disturbed {
    std::int32_t body;
    Wrench impulse = {};  // N s, N m s, since `since`
    double since = 0;     // s
  };

  std::vector<DisturbanceParameters> list_;
  std::array<Disturbed, 2> bodies_;  // by DisturbedBody
};

}  // namespace netpocket
