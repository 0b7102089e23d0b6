#include "engine/systems/pocket/pocket_interior.h"

#include "engine/state/pocket_groups.h"

namespace netpocket {

PocketInterior::PocketInterior(const Pocket& pocket)
    : roots_(pocket.structure.nodes(kRodRoots)),
      kinks_(pocket.structure.nodes(kRodKinks)),
      tips_(pocket.structure.nodes(kRodTips)) {}

// Radius of a polyline of points (radius, height) at a height; negative outside its heights.
double PocketInterior::radius_at(const std::vector<Eigen::Vector2d>& outline, double height) {
  for (std::size_t i = 0; i + 1 < outline.size(); ++i) {
    const double below = outline[i].y(), above = outline[i + 1].y();
    if (height < below || height > above || above == below) continue;
    const double part = (height - below) / (above - below);
    return (1 - part) * outline[i].x() + part * outline[i + 1].x();
  }
  return -1;
}

}  // namespace netpocket
