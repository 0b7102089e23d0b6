#pragma once
// The channels of closed-loop control: attitude, efforts, propellant and estimates of a controlled spacecraft, the
// winches of the closing ropes, the pressure of rods that are deflated, and the phase where events begin it. A run has
// those of the parts that its scenario has.

#include <memory>
#include <string>
#include <vector>

#include "engine/control/capture_times.h"
#include "engine/control/closed_loop.h"
#include "engine/control/deflation.h"
#include "engine/control/winch_control.h"
#include "engine/dynamics/system/cable_system.h"
#include "engine/state/channels.h"

namespace netpocket {

class ControlChannels {
 public:
  // Each of the first four may be null; the first three must outlive this. `spacecraft`: index of the body.
  ControlChannels(ClosedLoop* loop, const WinchControl* winches, const Deflation* deflation,
                  std::shared_ptr<const CaptureTimes> events, std::int32_t spacecraft);

  // Those of the parts that there are. They follow all others of the run.
  const std::vector<ChannelInfo>& infos() const { return infos_; }
  // Fills them. The rest of `snapshot` must just have been captured.
  void fill(Snapshot& snapshot) const;

 private:
  void add(const std::string& name, const std::string& unit, const std::string& meaning,
           ChannelKind kind = ChannelKind::value);
  void add_vector(const std::string& name, const std::string& unit, const std::string& meaning,
                  ChannelKind kind = ChannelKind::value);
  void add_loop();
  void add_winches();

  ClosedLoop* loop_;
  const WinchControl* winches_;
  const Deflation* deflation_;
  std::shared_ptr<const CaptureTimes> events_;
  std::int32_t spacecraft_;
  std::vector<ChannelInfo> infos_;
};

}  // namespace netpocket
