#pragma once
// Convex hull of points in space, by Qhull: Barber, Dobkin & Huhdanpaa (1996), The quickhull algorithm for convex
// hulls, ACM Trans. Math. Softw. 22(4), doi:10.1145/235815.235821. Pure functions: any thread may call them.

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace netpocket {

struct ConvexHull {
  // Points x with normal.dot(x) + offset <= 0 are on the inner side.
  struct Plane {
    Eigen::Vector3d normal;  // unit, outward
    double offset;           // m
  };
  double volume = 0;  // m^3
  double area = 0;    // m^2
  std::vector<Plane> planes;

  // Largest signed distance (m) from the planes: for a point inside, minus its distance from the hull; for one outside,
  // at most its distance.
  double signed_distance(const Eigen::Vector3d& point) const;
  bool contains(const Eigen::Vector3d& point) const { return signed_distance(point) <= 0; }
};

// Points: m, one column each. Nothing if they are fewer than four, lie in a plane, or are not finite.
std::optional<ConvexHull> convex_hull(const Eigen::Matrix3Xd& points);

}  // namespace netpocket
