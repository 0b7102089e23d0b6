#pragma once
// Changes material properties during a run: the friction of contacts, and the pressure in the rods through their
// wrinkling moment. Each changes gradually within 0.5 s (gradual_change.h), so that no force jumps. For the
// wrinkling moment its inverse changes gradually, which is zero for rods that do not wrinkle. The work of the change
// counts as energy put in.

#include <array>
#include <functional>

#include "engine/control/gradual_change.h"
#include "engine/dynamics/system/cable_system.h"
#include "engine/scenario/scenario.h"
#include "engine/systems/pocket/pocket.h"

namespace netpocket {

class MaterialChanges {
 public:
  // `system` must have been made from the pocket's model of that scenario, and must outlive this.
  MaterialChanges(const Pocket& pocket, CableSystem& system, const Scenario& scenario);

  // Begins the change to the values of another scenario at `now` (s).
  void change(const Scenario& scenario, double now);
  // To be called before each step: gives the system the values at `time` (s).
  void apply(double time);

  // Gives every number of the state to `visit`, which may change it; the system is then given the values of that state.
  // To be called before CableSystem::visit_state, which restores the energy account.
  void visit_state(const std::function<void(double&)>& visit);

 private:
  struct Rods {
    std::int32_t material;
    double moment;           // N m, wrinkling moment of the scenario
    GradualChange weakness;  // 1/(N m), 1/moment; 0 for rods that do not wrinkle
    double applied;          // weakness that the system has
  };

  void apply_friction(double friction);
  void apply_weakness(Rods& rods, double weakness);

  CableSystem& system_;
  GradualChange friction_;
  double applied_friction_;
  std::array<Rods, 2> rods_;  // below and above the kinks
};

}  // namespace netpocket
