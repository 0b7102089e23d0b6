#pragma once
// Finds the contact points of the shapes of two bodies.
// - A sphere touches where the other surface is nearest to its centre.
// - Boxes, cylinders and the parts of satellites are convex and touch as polytopes (polytope.h).
// - A mesh need not be convex. It and its partner touch at their corners, with the other's signed distance as depth,
//   and at convex edges that cross.
//
// The narrow phase of the library FCL is not suitable. For cylinders it finds one point, which jumps along a flank or
// round a rim, and it may throw (its issues 319, 391, 493). For meshes its depth is not that of the bodies (491, 574).
//
// A ShapePair remembers earlier placements. This changes the cost only: results do not depend on earlier calls.

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <vector>

#include "engine/bodies/shape.h"
#include "engine/contact/polytope.h"
#include "engine/contact/surface_features.h"
#include "engine/contact/touch.h"

namespace netpocket {

// A shape prepared for contact. Immutable: any thread may use it.
class TouchableShape {
 public:
  // A convex solid, or a mesh.
  struct Part {
    Shape solid;
    Eigen::Vector3d centre;            // m, in the shape's axes
    double radius;                     // m, about the centre
    std::optional<Polytope> polytope;  // empty for spheres and meshes
    SurfaceFeatures features;          // empty for spheres

    const Sphere* sphere() const { return std::get_if<Sphere>(&solid); }
    bool is_mesh() const { return std::holds_alternative<MeshShape>(solid); }
    SurfacePoint nearest(const Eigen::Vector3d& point) const { return nearest_surface_point(solid, point - centre); }
    bool is_nearer(const Eigen::Vector3d& point, double reach) const {
      return netpocket::is_nearer(solid, point - centre, reach);
    }
  };

  explicit TouchableShape(const Shape& shape);

  const std::vector<Part>& parts() const { return parts_; }
  double radius() const { return radius_; }  // m, about the origin

 private:
  std::vector<Part> parts_;
  double radius_;
};

class ShapePair {
 public:
  // Both shapes must outlive this.
  ShapePair(const TouchableShape& first, const TouchableShape& second);

  // Replaces `touches` by the contact points, in world axes. `first`, `second`: the placements of the bodies. Computes
  // nothing as long as the shapes cannot have met since the last search. One thread at a time.
  void find(const Placement& first, const Placement& second, std::vector<Touch>& touches);

 private:
  using Part = TouchableShape::Part;
  // Corners and edges of two parts that are near the other part and may touch it.
  struct Near {
    std::vector<std::int32_t> corners1, corners2, edges1, edges2;
    bool empty() const { return corners1.empty() && corners2.empty() && (edges1.empty() || edges2.empty()); }
  };
  struct MeshMemory {
    std::optional<Placement> place;  // at the last search
    Near near;
  };

  double way_since(const Placement& before, const Placement& now) const;
  double find_of_parts(std::size_t i, std::size_t j, const Placement& place, std::vector<Touch>& touches);
  double find_of_mesh(const Part& one, const Part& two, MeshMemory& memory, const Placement& place,
                      std::vector<Touch>& touches) const;
  Near find_near(const Part& one, const Part& two, const Placement& place) const;

  const TouchableShape &first_, &second_;
  double margin_;                   // m, within which features of meshes are kept
  std::vector<MeshMemory> meshes_;  // by part of the first, then of the second
  std::optional<Placement> place_;  // of the first in the second's axes, at the last search
  double clearance_ = 0;            // m, lower bound of the distance at the last search
};

}  // namespace netpocket
