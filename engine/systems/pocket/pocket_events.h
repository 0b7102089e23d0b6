#pragma once
// Watches a capture by a pocket for the events that start its closing and its towing and that end the towing. Commands
// nothing: it keeps the times that the other controllers share, and so comes before them.

#include <memory>
#include <string>
#include <vector>

#include "engine/control/capture_times.h"
#include "engine/control/contact_force.h"
#include "engine/control/controller.h"
#include "engine/systems/pocket/pocket_interior.h"

namespace netpocket {

class PocketEvents : public Controller {
 public:
  PocketEvents(const Scenario& scenario, const Pocket& pocket);

  std::shared_ptr<const CaptureTimes> times() const { return times_; }
  // Which events have been awaited in vain until a time (s), as a part of a sentence; empty: none.
  std::string awaited(double time) const;

  void update(const Measurements& measurements, double interval, Commands& commands) override;
  void after_step(const Measurements& measurements, double dt) override;
  void change(const Scenario& scenario, double now) override;
  void visit_state(const std::function<void(double&)>& visit) override;

 private:
  bool closing_begins(const Measurements& measurements) const;
  void begin_closing(double start);
  void adopt_given_times();

  ClosingParameters closing_;
  TowingParameters towing_;
  double closing_duration_;  // s
  double open_length_;       // m
  std::int32_t spacecraft_, base_, target_;
  PocketInterior interior_;
  ContactForce contact_;
  std::shared_ptr<CaptureTimes> times_;
};

}  // namespace netpocket
