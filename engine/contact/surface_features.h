#pragma once
// Corners and convex edges of a polyhedron, at which it can touch another one. Lengths in m, the polyhedron's axes.

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/bodies/triangle_mesh.h"
#include "engine/contact/polytope.h"

namespace netpocket {

struct FeatureCorner {
  Eigen::Vector3d point;
  double weight;  // share of the contact stiffness
};

struct FeatureEdge {
  Eigen::Vector3d begin, end;
  Eigen::Vector3d side1, side2;  // unit, in the plane of each face, perpendicular to the edge, pointing off the face
  double weight;                 // share of the contact stiffness

  // Whether a direction perpendicular to the edge lies between the normals of its faces.
  bool looks(const Eigen::Vector3d& direction) const {
    return symmetric_dot(direction, side1) >= 0 && symmetric_dot(direction, side2) >= 0;
  }
};

struct SurfaceFeatures {
  std::vector<FeatureCorner> corners;
  std::vector<FeatureEdge> edges;
};

SurfaceFeatures features_of(const Polytope& polytope);
// The weight of a corner is 8 times its share of the surface, at most 1. So a face of a mesh is about as stiff as that
// of a box, however finely it is divided.
SurfaceFeatures features_of(const TriangleMesh& mesh);

}  // namespace netpocket
