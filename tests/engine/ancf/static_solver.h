#pragma once
// Static equilibrium of a chain of cable elements, for the verification cases: Newton's method on the potential energy
// with load steps and a line search. A plain Newton iteration can jump to a spurious branch.

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "engine/math/vector.h"

namespace netpocket::test {

// Energy, force and tangent of one element, so that either evaluation fits.
struct ElasticElement {
  std::function<double(const ElementCoordinates&)> energy;
  std::function<ElementCoordinates(const ElementCoordinates&)> force;
  std::function<ElementTangent(const ElementCoordinates&)> tangent;
};

// A dead force on the last node, in the plane z = 0, or a moment about z that turns with it.
struct TipLoad {
  Eigen::Vector3d force = Eigen::Vector3d::Zero();  // N
  double moment = 0;                                // N m
};

struct StaticChain {
  int elements = 0;
  double length = 0;  // m, of the whole chain; straight along +x and clamped at the origin, in the plane z = 0
  ElasticElement element;
};

struct StaticResult {
  std::vector<ElementCoordinates> coordinates;  // of each element
  int iterations = 0;
  double residual = 0;  // largest unbalanced force relative to the largest nodal one

  Eigen::Vector3d tip() const { return coordinates.back().col(2); }
};

StaticResult solve(const StaticChain& chain, const TipLoad& load, int load_steps);

}  // namespace netpocket::test
