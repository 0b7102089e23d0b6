#pragma once
// The control loops of a pocket as data (state/control_loop_info.h), with the channels that only they have: of each
// controller and winch its state, set point and error, of the actuators their loads, and the disturbances that a
// scenario lists. They follow the known channels (state/channels.h), and those of control_channels.h follow them.

#include <string>
#include <vector>

#include "engine/control/closed_loop.h"
#include "engine/control/disturbances.h"
#include "engine/control/winch_control.h"
#include "engine/scenario/scenario.h"
#include "engine/state/channels.h"
#include "engine/state/control_loop_info.h"

namespace netpocket {

class LoopChannels {
 public:
  // `loop` and `winches` may be null; then, and without disturbances in the scenario, there are no channels. All must
  // outlive this. `spacecraft`, `target`: indices of bodies.
  LoopChannels(const Scenario& scenario, const ClosedLoop* loop, const WinchControl* winches,
               Disturbances* disturbances, std::int32_t spacecraft, std::int32_t target);

  const std::vector<ChannelInfo>& infos() const { return infos_; }
  const std::vector<ControlLoopInfo>& loops() const { return loops_; }
  // Fills them. The bodies of the snapshot must just have been captured.
  void fill(Snapshot& snapshot) const;

 private:
  using Names = std::vector<std::string>;

  Names add(const std::string& name, const std::string& unit, const std::string& meaning,
            ChannelKind kind = ChannelKind::value);
  Names add_vector(const std::string& name, const std::string& unit, const std::string& meaning,
                   ChannelKind kind = ChannelKind::value);
  void add_controllers(const std::vector<ControllerParameters>& controllers);
  void add_loads();
  void add_winches(WinchDrive drive);
  void add_disturbances();

  const ClosedLoop* loop_;
  const WinchControl* winches_;
  Disturbances* disturbances_;
  std::int32_t spacecraft_, target_;
  std::vector<bool> is_scalar_, is_torque_;  // by controller: of its quantity, of its demand
  std::vector<ChannelInfo> infos_;
  std::vector<ControlLoopInfo> loops_;
};

}  // namespace netpocket
