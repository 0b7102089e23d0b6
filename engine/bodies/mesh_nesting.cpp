#include "engine/bodies/mesh_nesting.h"

#include <cmath>
#include <memory>
#include <utility>

#include "engine/bodies/box_tree.h"
#include "engine/bodies/triangle_mesh.h"

namespace netpocket {
namespace {

using Eigen::Vector3d;

// The triangles of one part as a mesh that faces outwards. `inverted`: whether they face inwards.
MeshData part_mesh(const MeshData& mesh, const std::vector<std::int32_t>& triangles, bool inverted) {
  MeshData data;
  std::vector<std::pair<std::int32_t, std::int32_t>> numbers;  // vertex in the mesh, vertex here
  for (const std::int32_t t : triangles) {
    for (const std::int32_t corner : mesh.triangles[t]) numbers.emplace_back(corner, 0);
  }
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  for (auto& [vertex, number] : numbers) {
    number = static_cast<std::int32_t>(data.vertices.size());
    data.vertices.push_back(mesh.vertices[vertex]);
  }
  for (const std::int32_t t : triangles) {
    Triangle& added = data.triangles.emplace_back();
    for (int i = 0; i < 3; ++i) {
      added[i] = std::lower_bound(numbers.begin(), numbers.end(), std::pair(mesh.triangles[t][i], -1))->second;
    }
    if (inverted) std::swap(added[1], added[2]);
  }
  return data;
}

class Nesting {
 public:
  Nesting(const MeshData& mesh, const std::vector<std::int32_t>& part_of, const std::vector<MeshPart>& parts,
          double tolerance)
      : mesh_(mesh), parts_(parts), tolerance_(tolerance), triangles_(parts.size()), solids_(parts.size()) {
    for (std::size_t t = 0; t < part_of.size(); ++t) triangles_[part_of[t]].push_back(static_cast<std::int32_t>(t));
  }

  std::vector<PartNesting> find() {
    std::vector<Eigen::AlignedBox3d> boxes;
    for (const MeshPart& part : parts_) boxes.push_back(is_solid(part) ? part.bounds : Eigen::AlignedBox3d());
    const BoxTree tree(std::move(boxes));
    std::vector<PartNesting> nesting(parts_.size());
    for (std::size_t part = 0; part < parts_.size(); ++part) {
      if (!is_solid(parts_[part])) continue;
      std::vector<std::int32_t> others;
      tree.for_each_meeting(parts_[part].bounds, [&](std::int32_t other) {
        if (other != static_cast<std::int32_t>(part)) others.push_back(other);
      });
      nesting[part] = find_one(part, others);
    }
    return nesting;
  }

 private:
  PartNesting find_one(std::size_t part, const std::vector<std::int32_t>& others) {
    PartNesting result;
    const bool inverted = parts_[part].volume < 0;
    for (const std::int32_t t : triangles_[part]) {
      const Vector3d normal = area_vector(mesh_, mesh_.triangles[t]).normalized();
      if (normal.isZero()) continue;
      const Vector3d centre = centroid(mesh_, mesh_.triangles[t]);
      // The test point is slightly inside the volume that the part encloses. So faces of touching parts count as
      // outside each other.
      const auto holders = holders_of(centre + (inverted ? tolerance_ : -tolerance_) * normal, others);
      if (!holders) continue;
      if (result.in_place + result.misplaced == 0) result.holder = smallest(*holders);
      const bool in_place = (holders->size() % 2 == 1) == inverted;
      ++(in_place ? result.in_place : result.misplaced);
      if (!in_place && !result.place) result.place = centre;
    }
    return result;
  }

  // Parts that contain the point; empty optional if it is on the surface of one of them.
  std::optional<std::vector<std::int32_t>> holders_of(const Vector3d& point, const std::vector<std::int32_t>& others) {
    std::vector<std::int32_t> holders;
    for (const std::int32_t other : others) {
      if (!parts_[other].bounds.contains(point)) continue;
      const TriangleMesh& solid = solid_of(other);
      const double distance = solid.nearest(point - solid.centre_in_file()).distance;
      if (std::abs(distance) < tolerance_ / 4) return std::nullopt;
      if (distance < 0) holders.push_back(other);
    }
    return holders;
  }

  std::optional<std::int32_t> smallest(const std::vector<std::int32_t>& holders) const {
    std::optional<std::int32_t> found;
    for (const std::int32_t holder : holders) {
      if (!found || std::abs(parts_[holder].volume) < std::abs(parts_[*found].volume)) found = holder;
    }
    return found;
  }

  const TriangleMesh& solid_of(std::int32_t part) {
    if (!solids_[part]) {
      solids_[part] = TriangleMesh::of_closed(part_mesh(mesh_, triangles_[part], parts_[part].volume < 0));
    }
    return *solids_[part];
  }

  const MeshData& mesh_;
  const std::vector<MeshPart>& parts_;
  double tolerance_;
  std::vector<std::vector<std::int32_t>> triangles_;         // by part
  std::vector<std::shared_ptr<const TriangleMesh>> solids_;  // by part, facing outwards; made on demand
};

}  // namespace

std::vector<PartNesting> find_nesting(const MeshData& mesh, const std::vector<std::int32_t>& part_of,
                                      const std::vector<MeshPart>& parts, double tolerance) {
  return Nesting(mesh, part_of, parts, tolerance).find();
}

}  // namespace netpocket
