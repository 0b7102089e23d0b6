#pragma once
// Whether the target is inside a pocket.

#include <Eigen/Core>
#include <vector>

#include "engine/math/elementary.h"
#include "engine/state/snapshot.h"
#include "engine/systems/pocket/pocket.h"

namespace netpocket {

class PocketInterior {
 public:
  explicit PocketInterior(const Pocket& pocket);

  // Whether the target's centre lies between root and mouth, and nearer to the pocket's axis than the rods at its
  // height. Heights and radii are in the spacecraft's axes. Rods are polylines through their mean root, kink and tip.
  // `position(node)`: m.
  template <class Position>
  bool contains_target(const BodyState& craft, const BodyState& target, const Position& position) const {
    if (tips_.empty()) return false;
    const auto to_craft = [&](const Eigen::Vector3d& point) -> Eigen::Vector3d {
      return craft.attitude.conjugate() * (point - craft.position);
    };
    const auto mean = [&](const std::vector<std::int32_t>& nodes) -> Eigen::Vector2d {
      Eigen::Vector2d sum = Eigen::Vector2d::Zero();
      for (const std::int32_t node : nodes) {
        const Eigen::Vector3d p = to_craft(position(node));
        sum += Eigen::Vector2d(hypotenuse(p.x(), p.z()), p.y());
      }
      return sum / static_cast<double>(nodes.size());
    };
    const Eigen::Vector3d centre = to_craft(target.position);
    return hypotenuse(centre.x(), centre.z()) < radius_at({mean(roots_), mean(kinks_), mean(tips_)}, centre.y());
  }

  const std::vector<std::int32_t>& tips() const { return tips_; }  // nodes, by rod

 private:
  static double radius_at(const std::vector<Eigen::Vector2d>& outline, double height);

  std::vector<std::int32_t> roots_, kinks_, tips_;  // nodes, by rod
};

}  // namespace netpocket
