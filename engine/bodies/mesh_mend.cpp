#include "engine/bodies/mesh_mend.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "engine/bodies/mesh_doubles.h"
#include "engine/bodies/mesh_review.h"
#include "engine/bodies/mesh_thicken.h"
#include "engine/bodies/mesh_weld.h"
#include "engine/bodies/mesh_winding.h"
#include "engine/bodies/t_junctions.h"

namespace netpocket {
namespace {

// By triangle: whether its part lies in a plane and it faces against the first triangle of the part. The two sides of a
// panel may be divided into triangles differently, so that twins of triangles cannot be relied on.
std::vector<bool> backs_of_planes(const MeshData& mesh, const MeshReview& review) {
  constexpr double kParallel = 1 - 1e-9;  // least cosine between parallel normals
  std::vector<Eigen::Vector3d> normals(review.parts.size(), Eigen::Vector3d::Zero());
  std::vector<bool> is_plane(review.parts.size(), true), backs(mesh.triangles.size());
  for (std::size_t t = 0; t < backs.size(); ++t) {
    const Eigen::Vector3d normal = area_vector(mesh, mesh.triangles[t]).normalized();
    Eigen::Vector3d& first = normals[review.part_of[t]];
    if (first.isZero()) first = normal;
    backs[t] = first.dot(normal) < 0;
    if (std::abs(first.dot(normal)) < kParallel) is_plane[review.part_of[t]] = false;
  }
  for (std::size_t t = 0; t < backs.size(); ++t) backs[t] = backs[t] && is_plane[review.part_of[t]];
  return backs;
}

class Mender {
 public:
  Mender(const MeshData& data, const MendOptions& options) : options_(options) {
    join_corners(data);
    drop_doubles();
    split_edges();
    drop_backs();
    wind();
    thicken();
  }

  MendedMesh result() { return std::move(result_); }

 private:
  MeshData& mesh() { return result_.mesh; }

  // Adds a change such as "12 triangles turned ...". `thing` is in the singular.
  void note(std::size_t count, const char* thing, const std::string& what) {
    if (count > 0) result_.changes.push_back(fmt::format("{} {}{} {}", count, thing, count == 1 ? "" : "s", what));
  }

  void join_corners(const MeshData& data) {
    const double tolerance = options_.weld_tolerance > 0 ? options_.weld_tolerance : kWeldTolerance * mesh_extent(data);
    WeldedMesh welded = weld(data, tolerance);
    mesh() = std::move(welded.mesh);
    note(welded.joined, "corner", fmt::format("joined with others within {:.3g} m", tolerance * options_.unit));
    note(welded.shrunk, "triangle", "left out, being a line or a point");
  }

  void drop_doubles() {
    const std::vector<std::int32_t> doubles = find_doubles(mesh());
    std::vector<bool> dropped(mesh().triangles.size());
    for (const std::int32_t t : doubles) dropped[t] = true;
    drop_triangles(mesh(), dropped);
    note(doubles.size(), "triangle", "left out, being there twice");
  }

  void split_edges() {
    const auto places = split_t_junctions(mesh(), kTJunctionTolerance * mesh_extent(mesh()));
    note(places.size(), "corner", "joined with an edge of another triangle on which it lies");
  }

  // Keeps one side of each two-sided surface: the outer one if it is closed, either one of a panel that will get a
  // thickness.
  void drop_backs() {
    const MeshReview review = review_mesh(mesh());
    if (review.part_of.size() != mesh().triangles.size()) return;
    std::vector<bool> dropped(mesh().triangles.size());
    const std::vector<bool> behind = backs_of_planes(mesh(), review);
    std::size_t closed = 0, panels = 0;
    for (std::size_t t = 0; t < dropped.size(); ++t) {
      const MeshPart& part = review.parts[review.part_of[t]];
      if (!part.closed || !(part.two_sided || part.flat)) continue;
      if (!part.flat) {
        dropped[t] = part.volume < 0;
        closed += dropped[t] ? 1 : 0;
      } else if (options_.thickness > 0) {
        dropped[t] = part.two_sided ? review.back_of[t] < static_cast<std::int32_t>(t) : behind[t];
        panels += dropped[t] ? 1 : 0;
      }
    }
    drop_triangles(mesh(), dropped);
    note(closed, "triangle", "left out, being the inner side of another");
    note(panels, "triangle", "left out, being the back of another");
  }

  void wind() {
    const WindingChange change = wind_consistently(mesh());
    note(change.triangles, "triangle", "turned to face as the neighbours do");
    note(change.parts, "closed part", "turned to face outwards");
  }

  void thicken() {
    if (!(options_.thickness > 0)) return;
    const std::size_t parts = thicken_open_parts(mesh(), options_.thickness);
    note(parts, "open surface", fmt::format("given a thickness of {:g} m", options_.thickness * options_.unit));
    if (parts > 0) wind();
  }

  MendOptions options_;
  MendedMesh result_;
};

}  // namespace

MendedMesh mend_mesh(const MeshData& data, const MendOptions& options) { return Mender(data, options).result(); }

}  // namespace netpocket
