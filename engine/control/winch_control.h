#pragma once
// Winds the closing ropes with winches (winch.h), one for each rope, as the scenario's table [winch] says.
//
// Brakes are on until the closing starts. A rope may start later than the others, and its retractor may jam. The drive
// `length` follows the closing law; the others wind until the rope has its closed length. The motors' loops know the
// present tension, or the reading of a sensor.

#include <memory>
#include <optional>
#include <vector>

#include "engine/control/capture_times.h"
#include "engine/control/closing_control.h"
#include "engine/control/controller.h"
#include "engine/control/sensor_channel.h"
#include "engine/control/winch.h"
#include "engine/state/control_loop_info.h"

namespace netpocket {

class WinchControl : public Controller {
 public:
  // Winds the first ropes of the model. `open_lengths`: m, by rope.
  WinchControl(const Scenario& scenario, const std::vector<double>& open_lengths,
               std::shared_ptr<const CaptureTimes> times);

  void update(const Measurements& measurements, double interval, Commands& commands) override;
  void change(const Scenario& scenario, double now) override;
  double shortest_length(std::int32_t rope, double now, double until) const override;
  std::string suspicion() const override;
  void visit_state(const std::function<void(double&)>& visit) override;

  const std::vector<Winch>& winches() const { return winches_; }
  // What one of the winches does at `time` (s), and what it is commanded: m, m/s, N or N m by drive.
  LoopState state(std::size_t rope, double time) const;
  double set_point(std::size_t rope, double time) const { return command_at(rope, time).value; }
  // Torque of a motor by its limit.
  double load(std::size_t rope) const;
  const std::vector<double>& tensions() const { return tensions_; }  // N, at the beginning of the last step

 private:
  WinchCommand command_at(std::size_t rope, double time) const;
  WinchCommand command_at_own(std::size_t rope, double own_time) const;
  void command_all(double time);

  WinchParameters winch_;
  double least_length_;  // m
  std::vector<double> open_lengths_;
  std::shared_ptr<const CaptureTimes> times_;
  ClosingControl law_;
  std::vector<Winch> winches_;
  std::vector<double> tensions_;
  std::optional<SensorChannel> sensor_;
  double longest_step_ = 0;  // s, up to now
};

}  // namespace netpocket
