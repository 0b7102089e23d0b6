#pragma once
// Points along the cubic curves of elements.

#include <vector>

#include "engine/math/vector.h"
#include "engine/state/snapshot.h"
#include "engine/state/structure.h"

namespace netpocket {

struct CurvePoint {
  Eigen::Vector3d position;  // m, world
  Eigen::Vector3d tangent;   // dr/dp, dimensionless
};

// Samples elements at `segments` + 1 evenly spaced places, both ends included.
class ElementCurve {
 public:
  explicit ElementCurve(int segments);

  int point_count() const { return static_cast<int>(stations_.size()); }
  double fraction(int point) const { return static_cast<double>(point) / (point_count() - 1); }

  Eigen::Vector3d position(const Snapshot& snapshot, const StructureElement& element, int point) const;
  CurvePoint at(const Snapshot& snapshot, const StructureElement& element, int point) const;

 private:
  // Shape functions for unit length; the gradients' ones grow with the length, the others do not.
  struct Station {
    NodalWeights position;
    NodalWeights tangent;
  };
  std::vector<Station> stations_;
};

// Material length of an element now, m.
double current_length(const Snapshot& snapshot, const StructureElement& element);

}  // namespace netpocket
