#pragma once
// The channels that only a thrown net has: its area, its mouth, how far it has flown, its tensions, and how much of the
// target it wraps.

#include <vector>

#include "engine/dynamics/system/cable_system.h"
#include "engine/systems/thrown_net/net_surface.h"
#include "engine/systems/thrown_net/thrown_net.h"

namespace netpocket {

class ThrownNetChannels {
 public:
  explicit ThrownNetChannels(const ThrownNet& net);

  // All channels of such a run, with those that every system has.
  const std::vector<ChannelInfo>& infos() const { return infos_; }
  // Fills its own channels of `snapshot`, whose state must just have been captured from `system`.
  void fill(const CableSystem& system, Snapshot& snapshot) const;

 private:
  double corner_speed(const Snapshot& snapshot) const;
  double middle_tension(const CableSystem& system) const;

  std::vector<ChannelInfo> infos_;
  std::size_t first_own_;
  NetSurface surface_;
  double own_area_;        // m^2, of the flat net
  Eigen::Vector3d start_;  // m, centre of the folded net
  std::int32_t target_;
  std::vector<std::int32_t> corner_masses_, net_elements_;
  std::int32_t tether_end_, tether_rope_;
  std::size_t drawstrings_, rings_;  // ropes of the drawstring; of these, ropes through rings
};

}  // namespace netpocket
