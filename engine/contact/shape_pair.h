#pragma once
// Where the shapes of two bodies touch each other.
//
// A sphere touches where the other surface is nearest to its centre. Boxes, cylinders and the parts of satellites are
// convex and touch as polytopes do (polytope.h). A mesh need not be convex: it and what it meets touch by their
// corners, where the other's signed distance says how deep, and by convex edges that cross.
//
// FCL's narrow phase does not serve here: for cylinders it finds one point, which jumps along a flank or round a rim,
// and may throw (its issues 319, 391, 493); for meshes its depth says nothing of the bodies' (491, 574).
//
// Memory of where shapes have been changes the cost only: answers do not depend on what was asked before.

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <vector>

#include "engine/bodies/shape.h"
#include "engine/contact/polytope.h"
#include "engine/contact/surface_features.h"
#include "engine/contact/touch.h"

namespace netpocket {

// A shape made ready to be touched. Immutable.
class TouchableShape {
 public:
  // A convex solid, or a mesh.
  struct Part {
    Shape solid;
    Eigen::Vector3d centre;
    double radius;                     // m, about the centre
    std::optional<Polytope> polytope;  // none: a sphere, or a mesh
    SurfaceFeatures features;          // none: a sphere

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
  // Both must live as long as this.
  ShapePair(const TouchableShape& first, const TouchableShape& second);

  // Replaces `touches` by where they touch, in world axes. Nothing is computed while they cannot have come together
  // since the last time.
  void find(const Placement& first, const Placement& second, std::vector<Touch>& touches);

 private:
  using Part = TouchableShape::Part;
  // What may touch of a mesh and of what it meets: corners of the one near the other, and edges likewise.
  struct Near {
    std::vector<std::int32_t> corners1, corners2, edges1, edges2;
    bool empty() const { return corners1.empty() && corners2.empty() && (edges1.empty() || edges2.empty()); }
  };
  struct MeshMemory {
    std::optional<Placement> place;  // of the last search
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
  std::optional<Placement> place_;  // of the first in the second's axes, when they were last looked at
  double clearance_ = 0;            // m, at least, then
};

}  // namespace netpocket
