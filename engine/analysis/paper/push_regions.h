#pragma once
// Which part of the pocket pushes the target: the mouth above the kink row, or the cone below it.
//
// The paper (section 2) builds the pocket of an upper square net and a lower triangular one; they meet at the rods'
// kinks. An element belongs to the part in which its two nodes lie at the start of the recording, by their mean height
// against the mean height of the kinks; the cord around the kinks is neither. Rods and closing ropes count with the
// net. A frame holds contact points with their forces at that moment, the channel contact_fy the exact mean force over
// the interval. So the impulse of an interval is divided between the parts as their resultants that point its way,
// summed over the frames at both its ends; where none does, because an impact lasts shorter than the interval, over the
// next pair of frames about it that shows one, no farther than 0.1 s away: in that time no part of the pocket takes
// another's place. It stays unassigned where there is none.

#include <array>
#include <string>
#include <vector>

#include "engine/analysis/run_history.h"

namespace netpocket {

enum class Region { mouth, kink_row, cone };
inline constexpr std::size_t kRegionCount = 3;

struct RegionImpulse {
  std::array<double, kRegionCount> by_region{};  // N s, in y
  double unassigned = 0;                         // N s
  double mean_height = 0;                        // m, y of the contact points, weighted by their forces

  double total() const;
  // Part of the total; above 1 where the regions push against each other.
  double share(Region region) const;
  double share_unassigned() const;
};

class PushRegions {
 public:
  explicit PushRegions(const RunHistory& run);

  // Why the recording does not tell where forces act; empty when it does.
  const std::string& missing() const { return missing_; }
  // Of the y force on the target over the intervals that end at these frames.
  RegionImpulse impulse(FrameRange range) const;

 private:
  // Forces in y of a frame's contact points on the target.
  struct FrameForces {
    std::array<double, kRegionCount> y{};  // N
    double size = 0, moment = 0;           // N, N m: sums of |F_y| and of |F_y| times height
  };
  FrameForces forces(std::size_t frame, const std::vector<Region>& regions) const;
  // Parts in which an impulse of the interval before a frame is divided; all zero where nothing tells.
  std::array<double, kRegionCount> parts(std::size_t frame, double impulse) const;

  const RunHistory& run_;
  std::vector<FrameForces> forces_;  // by frame
  std::string missing_;
};

}  // namespace netpocket
