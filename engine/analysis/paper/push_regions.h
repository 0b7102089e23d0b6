#pragma once
// Finds which part of the pocket pushes the target: the mouth above the kink row or the cone below it.
//
// The paper (section 2) builds the pocket of an upper square net and a lower triangular one, which meet at the rods'
// kinks. The mean height of an element's nodes at the start of the recording, compared with that of the kinks, assigns
// it to a part. The cord around the kinks belongs to neither. Rods and closing ropes are assigned like the net.
//
// A frame holds contact points with their forces at that moment. The channel contact_fy holds the exact mean force over
// the interval. The impulse of an interval is divided between the parts in proportion to their resultants in its
// direction, summed over the frames at both its ends. If no resultant has that direction, because an impact was shorter
// than the interval, the next pair of frames outwards that has one is used, at most 0.1 s away. In that time no part of
// the pocket takes the place of another. If there is none, the impulse stays unassigned.

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
  double mean_height = 0;                        // m, mean y of the contact points, weighted by their forces

  double total() const;
  // Fraction of the total. Exceeds 1 where the regions push against each other.
  double share(Region region) const;
  double share_unassigned() const;
};

class PushRegions {
 public:
  explicit PushRegions(const RunHistory& run);

  // Why the recording does not tell where forces act; empty when it does tell.
  const std::string& missing() const { return missing_; }
  // Impulse of the y force on the target over the output intervals that end at these frames.
  RegionImpulse impulse(FrameRange range) const;

 private:
  // Sums over the contact points of a frame on the target.
  struct FrameForces {
    std::array<double, kRegionCount> y{};  // N
    double size = 0, moment = 0;           // N, N m: sums of |F_y| and of |F_y| times height
  };
  FrameForces forces(std::size_t frame, const std::vector<Region>& regions) const;
  // Weights by which the impulse of the interval before a frame is divided; all zero when they are not known.
  std::array<double, kRegionCount> parts(std::size_t frame, double impulse) const;

  const RunHistory& run_;
  std::vector<FrameForces> forces_;  // by frame
  std::string missing_;
};

}  // namespace netpocket
