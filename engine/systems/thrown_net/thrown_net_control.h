#pragma once
// What acts on a thrown net during a run: the events that start its closing and its towing, and the winches of its
// drawstring.

#include <memory>
#include <string>
#include <vector>

#include "engine/control/capture_times.h"
#include "engine/control/closing_control.h"
#include "engine/control/contact_force.h"
#include "engine/control/controller.h"
#include "engine/control/winch_control.h"
#include "engine/scenario/thrown_net_parameters.h"

namespace netpocket {

// Keeps the times that the other controllers share, and so comes before them. Commands nothing.
class ThrownNetEvents : public Controller {
 public:
  ThrownNetEvents(const Scenario& scenario, std::int32_t target);

  std::shared_ptr<const CaptureTimes> times() const { return times_; }
  // What the run waited for in vain until it ended; empty: nothing.
  std::string awaited() const;

  void update(const Measurements& measurements, double interval, Commands& commands) override;
  void after_step(const Measurements& measurements, double dt) override;
  void change(const Scenario& scenario, double now) override;
  void visit_state(const std::function<void(double&)>& visit) override;

 private:
  void adopt_given_times();

  ThrownNetParameters given_;
  TowingParameters towing_;
  std::int32_t target_;
  ContactForce contact_;
  std::shared_ptr<CaptureTimes> times_;
};

// Winds the drawstring's sides alike, with retractors that follow the closing law exactly or with motors, as the
// scenario's table [winch] says. The law is a cycloid from the open to the closed length (closing_law.h).
class DrawstringControl : public Controller {
 public:
  // `open_lengths`: m, by rope of the model.
  DrawstringControl(const Scenario& scenario, const std::vector<double>& open_lengths,
                    std::shared_ptr<const CaptureTimes> times);

  // Null if retractors follow the law exactly. Belongs to this object.
  const WinchControl* winches() const { return winches_; }

  void update(const Measurements& measurements, double interval, Commands& commands) override;
  void change(const Scenario& scenario, double now) override;
  double shortest_length(std::int32_t rope, double now, double until) const override;
  std::string suspicion() const override { return law_->suspicion(); }
  void visit_state(const std::function<void(double&)>& visit) override { law_->visit_state(visit); }

 private:
  const WinchControl* winches_ = nullptr;
  std::unique_ptr<Controller> law_;
};

}  // namespace netpocket
