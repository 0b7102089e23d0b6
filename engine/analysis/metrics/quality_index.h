#pragma once
// Two indices of how well a net encloses a target, from the net's convex hull. Both are 0 for a perfect wrap and grow
// without bound as it gets worse. Pure functions: any thread may call them.
//
// The index of Barnes & Botta (2020) compares the hull's volume and surface with those of the target, and distances
// with its characteristic length. Endo, Kojima & Trivailo (2022), Adv. Space Res. 70(10),
// doi:10.1016/j.asr.2022.09.024, found that it takes targets that are wrapped by half, or are concave, for captured.
// Their modification has the part of the target's volume that is outside the hull, the mean distance of the hull from
// the target's vertices, and how far the net is open.
//
// The formulas below are the definition used here. Only the quantities in these terms are those of the authors, by the
// abstract of Endo et al.; their formulas and weights were not at hand. The weights are choices of this program: 0.1,
// 0.1 and 0.8 for volume, surface and centre, because the first two also grow with a net that is merely large; and
// equal weights for the three terms of the modified index. The terms are given one by one, so that others can weigh
// them. Values compare captures with each other, not with those of the papers.

#include <Eigen/Core>
#include <vector>

#include "engine/analysis/metrics/convex_hull.h"
#include "engine/analysis/metrics/target_samples.h"
#include "engine/state/snapshot.h"

namespace netpocket {

// What the indices need of a target.
struct TargetGeometry {
  explicit TargetGeometry(const Shape& shape);

  double volume;                               // m^3
  double area;                                 // m^2
  double characteristic_length;                // m
  std::vector<SurfaceSample> surface_samples;  // stand in for the vertices, which round bodies do not have
  std::vector<Eigen::Vector3d> volume_samples;
};

struct QualityIndex {
  double volume = 0;   // |V_hull - V_target| / V_target
  double surface = 0;  // |S_hull - S_target| / S_target
  double centre = 0;   // distance between the net's centre and the target's, by its characteristic length

  double value() const { return 0.1 * volume + 0.1 * surface + 0.8 * centre; }
};

struct ModifiedQualityIndex {
  double outside = 0;   // share of the target's volume outside the hull
  double distance = 0;  // mean distance of the hull from the target's surface, by its characteristic length
  double opening = 0;   // area of the mouth by that at the start

  double value() const { return (outside + distance + opening) / 3; }
};

// `net_centre`: mean of the net's nodes, m, world axes. `hull`: of these nodes.
QualityIndex quality_index(const TargetGeometry& target, const BodyState& body, const ConvexHull& hull,
                           const Eigen::Vector3d& net_centre);
ModifiedQualityIndex modified_quality_index(const TargetGeometry& target, const BodyState& body, const ConvexHull& hull,
                                            double mouth_opening);

}  // namespace netpocket
