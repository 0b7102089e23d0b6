#pragma once
// Asks the controllers of a run for their commands and gives these to the system. A controller is asked before every
// step or, if it is sampled, in the first step of each period; its control of bodies is held in between.
//
// Energy: what controls do to bodies and what winding does to ropes counts as energy input of the system.
// Thread contract: the thread of the run.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "engine/control/controller.h"

namespace netpocket {

class ControlLoop {
 public:
  // `system` must outlive the loop.
  explicit ControlLoop(CableSystem& system);

  // Adds a controller. Later ones rule where two prescribe the same. `period`: s; 0: asked before every step.
  void add(std::unique_ptr<Controller> controller, double period = 0);

  // To be called before and after each step of `dt` (s).
  void before_step(double dt);
  void after_step(double dt);
  // Adopts the strategy of another scenario from the system's present time on.
  void change(const Scenario& scenario);

  // Shortest length (m) that each rope is expected to have until a time (s), by rope. Where no controller knows, the
  // present rate and acceleration are assumed to go on. The reference is valid until the next call.
  const std::vector<double>& shortest_lengths(double until);
  // The first suspicion of a controller (controller.h); empty: none.
  std::string suspicion() const;

  // Gives every number of the state to `visit`, always in the same order. `visit` may change the number.
  void visit_state(const std::function<void(double&)>& visit);

 private:
  struct Entry {
    std::unique_ptr<Controller> controller;
    double period;       // s
    Commands commands;   // its last ones
    double next_sample;  // s
  };

  CableSystem* system_;
  std::vector<Entry> entries_;
  Commands total_;
  std::vector<double> shortest_;
};

}  // namespace netpocket
