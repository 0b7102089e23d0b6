#pragma once
// The largest load on each part of a target. Thread contract: one thread at a time per object.

#include <Eigen/Core>
#include <map>
#include <string>
#include <vector>

#include "engine/state/snapshot.h"
#include "engine/state/structure.h"

namespace netpocket {

// Names of a shape's parts: "bus", "left panel", ... of a satellite; "body" for shapes that have no parts.
std::vector<std::string> part_names(const Shape& shape);

// Name of the part of a shape whose surface is nearest to a point (m, body axes).
std::string part_name(const Shape& shape, const Eigen::Vector3d& point);

struct PartLoad {
  double force = 0;  // N, size of the sum of the contact forces on the part
  double time = 0;   // s
};

class TargetLoads {
 public:
  // Adds the contact forces of a snapshot on body `target` (index into Structure::bodies). Forces between frames are
  // not seen: blows are shorter than that, so that only a high frame rate bounds the peak of a blow.
  void add(const Structure& structure, const Snapshot& snapshot, std::int32_t target);

  // Largest load by part. Parts that nothing has touched are missing.
  const std::map<std::string, PartLoad>& largest() const { return largest_; }

 private:
  std::map<std::string, PartLoad> largest_;
};

}  // namespace netpocket
