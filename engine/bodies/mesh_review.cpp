#include "engine/bodies/mesh_review.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "engine/bodies/mesh_crossings.h"
#include "engine/bodies/mesh_doubles.h"
#include "engine/bodies/mesh_nesting.h"
#include "engine/bodies/mesh_weld.h"

namespace netpocket {
namespace {

using Eigen::Vector3d;

// The word for one thing or for many.
const char* plural(std::size_t count, const char* one, const char* many) { return count == 1 ? one : many; }

class Reviewer {
 public:
  explicit Reviewer(const MeshData& data) {
    if (std::string problem = number_fault(data); !problem.empty()) {
      add(MeshFaultKind::numbers, std::move(problem));
      return;
    }
    check_size(data);
    if (found(MeshFaultKind::empty) || found(MeshFaultKind::too_many)) return;
    take_welded(data);
    check_doubles();
    review_.edges = find_edges(review_.mesh);
    check_edges();
    split_vertices(review_.mesh, review_.edges);
    find_parts();
    check_volumes();
    check_backs();
    check_crossings();
    check_nesting();
  }

  MeshReview result() {
    const auto by_kind = [](const MeshFault& a, const MeshFault& b) { return a.kind < b.kind; };
    std::stable_sort(review_.faults.begin(), review_.faults.end(), by_kind);
    return std::move(review_);
  }

 private:
  void add(MeshFaultKind kind, std::string text, std::vector<Vector3d> places = {}) {
    if (places.size() > kMostFaultPlaces) places.resize(kMostFaultPlaces);
    review_.faults.push_back({kind, std::move(text), std::move(places)});
  }
  bool found(MeshFaultKind kind) const {
    return std::any_of(review_.faults.begin(), review_.faults.end(), [&](const auto& f) { return f.kind == kind; });
  }

  void check_size(const MeshData& data) {
    if (data.triangles.empty()) return add(MeshFaultKind::empty, "has no triangles");
    if (data.triangles.size() > kLargestTriangleCount) {
      return add(MeshFaultKind::too_many,
                 fmt::format("has {} triangles; {} are allowed", data.triangles.size(), kLargestTriangleCount));
    }
    const double extent = mesh_extent(data);
    if (!(extent <= kLargestMeshExtent && extent >= kSmallestMeshExtent)) {
      add(MeshFaultKind::extent,
          fmt::format("is {:.4g} m large, not {:g} m to {:g} m as is allowed: is its unit right?", extent,
                      kSmallestMeshExtent, kLargestMeshExtent));
    }
    extent_ = extent;
  }

  void take_welded(const MeshData& data) {
    WeldedMesh welded = weld(data, kWeldTolerance * extent_);
    review_.mesh = std::move(welded.mesh);
    review_.weld_tolerance = welded.tolerance;
    review_.joined = welded.joined;
    if (review_.mesh.triangles.empty()) {
      add(MeshFaultKind::empty, "has no triangles but such that shrink to a line or a point");
    }
  }

  void check_doubles() {
    const MeshData& mesh = review_.mesh;
    const std::vector<std::int32_t> doubles = find_doubles(mesh);
    review_.back_of = find_backs(mesh);
    std::vector<Vector3d> places;
    for (const std::int32_t t : doubles) places.push_back(centroid(mesh, mesh.triangles[t]));
    if (places.empty()) return;
    add(MeshFaultKind::doubled,
        fmt::format("has {} {} that {} there twice, one of them at {}", places.size(),
                    plural(places.size(), "triangle", "triangles"), plural(places.size(), "is", "are"),
                    place_text(places[0])),
        places);
  }

  std::vector<Vector3d> middles(const std::vector<TriangleSide>& sides) const {
    std::vector<Vector3d> places;
    for (const TriangleSide& side : sides) places.push_back(middle(review_.mesh, side));
    return places;
  }

  void check_edges() {
    const MeshEdges& edges = review_.edges;
    std::vector<Vector3d> places = middles(edges.open);
    for (const Vector3d& place : middles(edges.forked)) places.push_back(place);
    if (!places.empty()) {
      add(MeshFaultKind::open,
          fmt::format("is not watertight: {} of its edges {} not join exactly two triangles, one of them at {}",
                      places.size(), plural(places.size(), "does", "do"), place_text(places[0])),
          places);
    }
    if (edges.turned.empty()) return;
    places = middles(edges.turned);
    add(MeshFaultKind::turned,
        fmt::format("has neighbouring triangles that face opposite ways, at {} edges, one of them at {}", places.size(),
                    place_text(places[0])),
        places);
  }

  void find_parts() {
    const MeshData& mesh = review_.mesh;
    review_.part_of = part_numbers(review_.edges);
    std::vector<MeshPart>& parts = review_.parts;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const Triangle& triangle = mesh.triangles[t];
      const auto number = static_cast<std::size_t>(review_.part_of[t]);
      if (number == parts.size()) {
        parts.emplace_back().place = mesh.vertices[triangle[0]];
        parts.back().closed = true;
      }
      MeshPart& part = parts[number];
      ++part.triangles;
      for (const std::int32_t corner : triangle) part.bounds.extend(mesh.vertices[corner]);
      part.area += area_vector(mesh, triangle).norm() / 2;
      // Relative to a point of the part, so that parts far from the origin lose no digits.
      part.volume += (mesh.vertices[triangle[0]] - part.place).dot(area_vector(mesh, triangle)) / 6;
      for (const std::int32_t neighbour : review_.edges.neighbours[t]) part.closed = part.closed && neighbour >= 0;
    }
    for (MeshPart& part : parts) part.two_sided = true;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      if (review_.back_of[t] < 0) parts[review_.part_of[t]].two_sided = false;
    }
    for (const TriangleSide& side : review_.edges.turned) parts[review_.part_of[side.triangle]].closed = false;
    constexpr double kFlat = 1e-10;  // fraction of area times extent
    for (MeshPart& part : parts)
      part.flat = std::abs(part.volume) <= kFlat * part.area * part.bounds.sizes().maxCoeff();
  }

  // Places of the closed parts for which `is_bad` holds.
  template <typename Test>
  std::vector<Vector3d> places_of(const Test& is_bad) const {
    std::vector<Vector3d> places;
    for (const MeshPart& part : review_.parts) {
      if (part.closed && is_bad(part)) places.push_back(part.bounds.center());
    }
    return places;
  }

  void check_volumes() {
    const auto places = places_of([](const MeshPart& part) { return part.flat; });
    if (places.empty()) return;
    if (places.size() == review_.parts.size()) return add(MeshFaultKind::flat, "encloses no volume", places);
    add(MeshFaultKind::flat,
        fmt::format("has {} {} that {} no volume, such as a panel without thickness: one of {} parts, at {}",
                    places.size(), plural(places.size(), "part", "parts"), plural(places.size(), "encloses", "enclose"),
                    review_.parts.size(), place_text(places[0])),
        places);
  }

  void check_backs() {
    const auto places = places_of([](const MeshPart& part) { return part.two_sided && !part.flat; });
    if (places.empty()) return;
    const std::string what = "two-sided: each triangle is there twice, once facing each way";
    if (places.size() == review_.parts.size()) return add(MeshFaultKind::two_sided, "is " + what, places);
    add(MeshFaultKind::two_sided,
        fmt::format("has {} of {} parts that are {}, one of them at {}", places.size(), review_.parts.size(), what,
                    place_text(places[0])),
        places);
  }

  void check_crossings() {
    std::vector<std::int32_t> closed = review_.part_of;
    for (std::int32_t& part : closed) {
      if (!is_solid(review_.parts[part])) part = -1;
    }
    for (const Crossing& c : find_crossings(review_.mesh, closed, CrossingPairs::of_different_parts,
                                            kTouchingTolerance * extent_, kMostFaultPlaces)) {
      crossings_.push_back(c.place);
    }
  }

  void check_nesting() {
    const auto nesting = find_nesting(review_.mesh, review_.part_of, review_.parts, kTouchingTolerance * extent_);
    std::vector<Vector3d> inward, nested;
    double inward_volume = 0;
    std::size_t crossed = 0;
    for (std::size_t i = 0; i < nesting.size(); ++i) {
      const MeshPart& part = review_.parts[i];
      if (nesting[i].misplaced == 0) continue;
      if (nesting[i].in_place > 0) {
        ++crossed;
        if (crossings_.size() < kMostFaultPlaces) crossings_.push_back(*nesting[i].place);
      } else if (part.volume < 0) {
        inward.push_back(part.bounds.center());
        inward_volume += part.volume;
      } else {
        nested.push_back(part.bounds.center());
      }
    }
    report_inward(inward, inward_volume);
    if (!crossings_.empty()) {
      add(MeshFaultKind::crossing,
          fmt::format(
              "has parts that go through each other, one of the places is {}: its volume would count twice what "
              "they share",
              place_text(crossings_[0])),
          crossings_);
    }
    if (nested.empty()) return;
    add(MeshFaultKind::nested,
        fmt::format("has {} {} in the solid of another one that {} outwards, one of them at {}: a hollow faces inwards",
                    nested.size(), plural(nested.size(), "part", "parts"), plural(nested.size(), "faces", "face"),
                    place_text(nested[0])),
        nested);
  }

  void report_inward(const std::vector<Vector3d>& places, double volume) {
    if (places.empty()) return;
    if (places.size() == review_.parts.size()) {
      return add(MeshFaultKind::inward,
                 fmt::format("is inverted: its triangles face inwards (volume {:.4g} m^3)", volume), places);
    }
    add(MeshFaultKind::inward,
        fmt::format("has {} {} of {} whose triangles face inwards without being a hollow of another one, one of them "
                    "at {}",
                    places.size(), plural(places.size(), "part", "parts"), review_.parts.size(), place_text(places[0])),
        places);
  }

  MeshReview review_;
  double extent_ = 0;
  std::vector<Vector3d> crossings_;
};

}  // namespace

std::string place_text(const Vector3d& p) { return fmt::format("({:.4g}, {:.4g}, {:.4g}) m", p.x(), p.y(), p.z()); }

std::string number_fault(const MeshData& data) {
  const auto count = static_cast<std::int32_t>(data.vertices.size());
  for (const Triangle& triangle : data.triangles) {
    for (const std::int32_t corner : triangle) {
      if (corner < 0 || corner >= count) return "has a triangle with a corner that does not exist";
    }
  }
  for (const Vector3d& vertex : data.vertices) {
    if (!vertex.allFinite()) return "has a corner whose coordinates are not finite numbers";
  }
  return {};
}

MeshReview review_mesh(const MeshData& data) { return Reviewer(data).result(); }

}  // namespace netpocket
