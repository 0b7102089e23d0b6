#pragma once
// A closed surface of triangles as the shape of a body. It has been checked, its centre of mass is at the origin, and
// it answers distance queries. Immutable: any thread may use it. Lengths in m, body axes.
//
// Mass properties are volume integrals over the uniformly filled solid, converted into sums over the triangles by the
// divergence theorem: Mirtich (1996), Fast and accurate computation of polyhedral mass properties, J. Graphics Tools
// 1(2), doi:10.1080/10867651.1996.10487458. Closed form for triangles: Eberly (2002), Polyhedral Mass Properties
// (Revisited), Geometric Tools.
//
// The sign of a distance comes from the angle-weighted pseudo-normal at the nearest point, which is correct at faces,
// edges and corners: Baerentzen & Aanaes (2005), IEEE Trans. Vis. Comput. Graph. 11(3), doi:10.1109/TVCG.2005.49.

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "engine/bodies/mesh_data.h"
#include "engine/bodies/mesh_edges.h"
#include "engine/bodies/surface_point.h"
#include "engine/bodies/triangle_tree.h"

namespace netpocket {

class TriangleMesh {
 public:
  using Result = std::variant<std::shared_ptr<const TriangleMesh>, std::string>;

  // Makes a mesh of one or several closed surfaces. A surface inside another bounds a hollow. Corners that differ by
  // round-off are joined. If review_mesh() finds faults, returns the first as the rest of a sentence that begins with
  // the mesh's name ("is not watertight: ...").
  static Result make(const MeshData& data);
  // Makes a mesh of the vertices and triangles of an earlier mesh that was stored. Joins no corners, and checks only
  // what the computations rely on. Errors as in make().
  static Result restore(MeshData data);
  // Makes a mesh of closed surfaces that must face outwards and enclose a volume; this is not checked.
  static std::shared_ptr<const TriangleMesh> of_closed(MeshData data);

  const std::vector<Eigen::Vector3d>& vertices() const { return data_.vertices; }
  const std::vector<Triangle>& triangles() const { return data_.triangles; }
  const Eigen::Vector3d& face_normal(std::size_t triangle) const { return face_normals_[triangle]; }
  const Eigen::Vector3d& vertex_normal(std::size_t vertex) const { return vertex_normals_[vertex]; }

  double volume() const { return volume_; }                              // m^3
  const Eigen::Vector3d& centre_in_file() const { return centre_; }      // m, centre of mass in the given coordinates
  const Eigen::Matrix3d& unit_inertia() const { return unit_inertia_; }  // m^2, about the origin, per unit mass
  const Eigen::AlignedBox3d& bounds() const { return bounds_; }
  double bounding_radius() const { return bounding_radius_; }  // m, about the origin
  double typical_edge() const { return typical_edge_; }        // m, edge of an equilateral triangle of mean area
  // Number of different corners that make() joined, and its tolerance (m).
  std::size_t joined_corners() const { return joined_corners_; }
  double weld_tolerance() const { return weld_tolerance_; }

  // Nearest surface point. Of equally near triangles the first in the tree decides. The distance is NaN if the point is
  // not finite.
  SurfacePoint nearest(const Eigen::Vector3d& point) const;
  // Whether the signed distance is at most `reach` (m, >= 0) or the point is not finite. Far cheaper than the distance.
  bool is_nearer(const Eigen::Vector3d& point, double reach) const;

  // As nearest(), but among the triangles at these places in the tree.
  SurfacePoint nearest_among(const Eigen::Vector3d& point, std::span<const std::int32_t> places) const;
  const TriangleTree& tree() const { return tree_; }

 private:
  TriangleMesh(MeshData data, const MeshEdges& edges);  // each edge must join two triangles
  void integrate();
  void find_normals(const MeshEdges& edges);
  SurfacePoint surface_point(const Eigen::Vector3d& point, const TriangleHit& hit) const;
  Eigen::Vector3d pseudo_normal(const TriangleHit& hit) const;

  MeshData data_;
  double volume_ = 0;
  Eigen::Vector3d centre_ = Eigen::Vector3d::Zero();
  Eigen::Matrix3d unit_inertia_ = Eigen::Matrix3d::Zero();
  Eigen::AlignedBox3d bounds_;
  double bounding_radius_ = 0;
  double typical_edge_ = 0;
  std::size_t joined_corners_ = 0;
  double weld_tolerance_ = 0;
  std::vector<Eigen::Vector3d> face_normals_;                 // by triangle
  std::vector<std::array<Eigen::Vector3d, 3>> edge_normals_;  // by triangle, for the edges 0-1, 1-2, 2-0
  std::vector<Eigen::Vector3d> vertex_normals_;               // by vertex
  TriangleTree tree_;
};

}  // namespace netpocket
