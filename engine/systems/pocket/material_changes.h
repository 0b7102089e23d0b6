#pragma once
// Changes material properties during a run: the friction of contacts, and the pressure in the rods through their
// wrinkling moment. Each changes gradually within 0.5 s (gradual_change.h), so that no force jumps. For the
// wrinkling moment its inverse changes gradually, which is zero for rods that do not wrinkle. Deflation (deflation.h)
// lowers that moment in proportion to the pressure. The work of the change counts as energy put in.

#include <functional>
#include <memory>
#include <vector>

#include "engine/control/capture_times.h"
#include "engine/control/controller.h"
#include "engine/control/deflation.h"
#include "engine/control/gradual_change.h"
#include "engine/scenario/scenario.h"
#include "engine/systems/pocket/pocket.h"

namespace netpocket {

class MaterialChanges : public Controller {
 public:
  MaterialChanges(const Scenario& scenario, const std::vector<RodMaterial>& rods,
                  std::shared_ptr<const CaptureTimes> times);

  const Deflation& deflation() const { return deflation_; }

  void update(const Measurements& measurements, double interval, Commands& commands) override;
  void change(const Scenario& scenario, double now) override;
  void visit_state(const std::function<void(double&)>& visit) override;

 private:
  struct Rods {
    RodMaterial of;
    double moment;           // N m, wrinkling moment of the scenario
    GradualChange weakness;  // 1/(N m), 1/moment; 0 for rods that do not wrinkle

    double moment_at(double time) const;
  };

  GradualChange friction_;
  Deflation deflation_;
  std::vector<Rods> rods_;
};

}  // namespace netpocket
