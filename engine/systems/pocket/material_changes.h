#pragma once
// Properties of the material that can be changed in the midst of a run: friction of contacts, and the pressure in the
// rods, through the moment at which they wrinkle. Each goes over to its new value within half a second
// (gradual_change.h): forces that follow it do so without a jump. The wrinkling moment goes by its inverse, which is
// zero for rods that do not wrinkle; the work of the change is booked as put in.

#include <array>
#include <functional>

#include "engine/control/gradual_change.h"
#include "engine/dynamics/system/cable_system.h"
#include "engine/scenario/scenario.h"
#include "engine/systems/pocket/pocket.h"

namespace netpocket {

class MaterialChanges {
 public:
  // `system`, whose model is the pocket's of that scenario, must outlive this.
  MaterialChanges(const Pocket& pocket, CableSystem& system, const Scenario& scenario);

  // Goes over to what another scenario says, from `now` (s) on.
  void change(const Scenario& scenario, double now);
  // To be called before each step: gives the system what holds at `time` (s).
  void apply(double time);

  // Gives every number of the state to `visit`, which may change it: then the system is given what held in that state.
  // To be called before the system's own walk, which sets the account of energy right.
  void visit_state(const std::function<void(double&)>& visit);

 private:
  struct Rods {
    std::int32_t material;
    double moment;           // N m, that of the scenario
    GradualChange weakness;  // 1/moment, 0 where rods do not wrinkle
    double applied;          // weakness that the system has
  };

  void apply_friction(double friction);
  void apply_weakness(Rods& rods, double weakness);

  CableSystem& system_;
  GradualChange friction_;
  double applied_friction_;
  std::array<Rods, 2> rods_;  // lower and upper
};

}  // namespace netpocket
