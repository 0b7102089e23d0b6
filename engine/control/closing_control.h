#pragma once
// Winds the closing ropes by the closing law of the scenario. A change of the law during a run leads from the present
// motion to the new law without a jump (closing_transition.h).

#include <memory>
#include <optional>
#include <vector>

#include "engine/control/capture_times.h"
#include "engine/control/closing_law.h"
#include "engine/control/closing_transition.h"
#include "engine/control/controller.h"

namespace netpocket {

class ClosingControl : public Controller {
 public:
  // Winds the first ropes of the model. `open_lengths`: m, by rope. `times`: their start of the closing, which may be
  // infinite at first, takes the place of the scenario's; null: the scenario's time.
  ClosingControl(const ClosingParameters& closing, const std::vector<double>& open_lengths,
                 std::shared_ptr<const CaptureTimes> times = nullptr);

  // Motion of a rope at a time (s) by the present law.
  RopeMotion motion(std::size_t rope, double time) const;
  // By rope, the index of a law that it shares with all ropes of the same index: their motions are equal.
  const std::vector<std::size_t>& laws() const { return schedule_of_rope_; }

  // Adopts the start of the closing from `times`.
  void follow_start();

  void update(const Measurements& measurements, double interval, Commands& commands) override;
  void change(const Scenario& scenario, double now) override;
  double shortest_length(std::int32_t rope, double now, double until) const override;
  std::string suspicion() const override;
  void visit_state(const std::function<void(double&)>& visit) override;

 private:
  void follow_changed_law();
  void make_schedules();

  ClosingParameters closing_;
  std::vector<double> open_lengths_;
  std::shared_ptr<const CaptureTimes> times_;
  std::vector<ClosingSchedule> schedules_;     // one for each distinct open length
  std::vector<std::size_t> schedule_of_rope_;  // index into schedules_
  std::vector<RopeMotion> motions_;            // workspace, by schedule
  // Since the first change all ropes follow the law of the first one.
  std::optional<ClosingTransition> transition_;
  double changed_ = -1;       // s, time of the last change; negative: never
  ClosingState at_change_{};  // state of the ropes at that time
  double fastest_ = 0;        // m/s, largest speed of the ropes up to now
};

}  // namespace netpocket
