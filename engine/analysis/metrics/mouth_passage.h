#pragma once
// The mouth against the target: how it closes, how near its ropes come to the target, how far the target is from
// leaving through it. Thread contract: one thread at a time per object.

#include <limits>
#include <optional>
#include <vector>

#include "engine/state/snapshot.h"
#include "engine/state/structure.h"

namespace netpocket {

// Area (m^2) of the mouth's polygon (net_geometry.h); NaN if the structure has no mouth.
double mouth_area(const Structure& structure, const Snapshot& snapshot);

class MouthPassage {
 public:
  struct Gap {
    double value = std::numeric_limits<double>::quiet_NaN();  // m
    double time = std::numeric_limits<double>::quiet_NaN();   // s
  };

  // `target`: index into Structure::bodies. `closing_end`: s; NaN: unknown. The structure must outlive the object.
  MouthPassage(const Structure& structure, std::optional<std::size_t> target, double closing_end);

  // `net`: nodes of the net.
  void add(const Snapshot& snapshot, const std::vector<std::int32_t>& net);

  // Time (s) at which the mean distance between adjacent tips has come 95 % of the way from its first value to the
  // shortest length that the closing law ever commanded. NaN if it never has, or if nothing was to be closed.
  double closed_time() const;

  // Smallest distance between the ropes' surface and the target's, over all frames. Taken at five points of every
  // element, so that it is too large by at most the square of their spacing by eight times the sum of gap and the
  // surface's radius of curvature.
  const Gap& smallest_gap() const { return gap_; }

  // From the end of the closing on; NaN before it. The depth (m) is that of the target's centre of mass behind the mean
  // plane of the mouth, its least value. The opening is the diameter of a circle with the area of the mouth by the
  // target's smallest extent along its axes, its largest value. A target can leave only with a negative depth, and a
  // rigid mouth lets a convex target pass only with an opening above 1.
  double escape_depth() const { return escape_depth_; }
  double escape_opening() const { return escape_opening_; }

 private:
  void measure_gap(const Snapshot& snapshot);
  void measure_escape(const Snapshot& snapshot, const std::vector<std::int32_t>& net);

  const Structure& structure_;
  std::optional<std::size_t> target_;
  double closing_end_;
  std::vector<std::int32_t> ropes_;
  std::vector<double> times_, lengths_;  // s, m, by frame
  double commanded_ = std::numeric_limits<double>::infinity();
  Gap gap_;
  double escape_depth_ = std::numeric_limits<double>::quiet_NaN();
  double escape_opening_ = std::numeric_limits<double>::quiet_NaN();
};

}  // namespace netpocket
