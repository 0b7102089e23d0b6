#include "engine/bodies/mesh_winding.h"

#include <utility>
#include <vector>

#include "engine/bodies/mesh_edges.h"
#include "engine/bodies/mesh_nesting.h"
#include "engine/bodies/mesh_review.h"
#include "engine/bodies/mesh_weld.h"

namespace netpocket {
namespace {

void turn(Triangle& t) { std::swap(t[1], t[2]); }

// The triangles of a part, and those of them that face differently from the first one.
struct Part {
  std::vector<std::int32_t> triangles;
  std::vector<std::int32_t> turned;
  bool orientable = true;
};

class PartWalk {
 public:
  PartWalk(const MeshData& mesh, const MeshEdges& edges)
      : mesh_(mesh), edges_(edges), state_(mesh.triangles.size(), State::unseen) {}

  bool seen(std::size_t triangle) const { return state_[triangle] != State::unseen; }

  Part walk(std::int32_t first) {
    Part part;
    state_[first] = State::like_first;
    part.triangles = {first};
    for (std::size_t i = 0; i < part.triangles.size(); ++i) {
      const std::int32_t t = part.triangles[i];
      if (state_[t] == State::turned) part.turned.push_back(t);
      for (int edge = 0; edge < 3; ++edge) {
        const std::int32_t neighbour = edges_.neighbours[t][edge];
        if (neighbour < 0) continue;
        const bool same = runs_along(t, edge, neighbour);  // same direction: they face opposite ways
        const State wanted = (state_[t] == State::turned) != same ? State::turned : State::like_first;
        State& state = state_[neighbour / 3];
        if (state == State::unseen) {
          state = wanted;
          part.triangles.push_back(neighbour / 3);
        } else if (state != wanted) {
          part.orientable = false;
        }
      }
    }
    return part;
  }

 private:
  enum class State : char { unseen, like_first, turned };

  bool runs_along(std::int32_t t, int edge, std::int32_t neighbour) const {
    return mesh_.triangles[t][edge] == mesh_.triangles[neighbour / 3][neighbour % 3];
  }

  const MeshData& mesh_;
  const MeshEdges& edges_;
  std::vector<State> state_;
};

void turn_neighbours(MeshData& mesh, WindingChange& change) {
  const MeshEdges edges = find_edges(mesh);
  PartWalk walk(mesh, edges);
  std::vector<std::int32_t> turned;
  std::vector<bool> minority(mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (walk.seen(t)) continue;
    Part part = walk.walk(static_cast<std::int32_t>(t));
    if (!part.orientable) {
      ++change.unorientable;
      continue;
    }
    const bool few = 2 * part.turned.size() <= part.triangles.size();
    for (const std::int32_t i : part.turned) minority[i] = true;
    for (const std::int32_t i : part.triangles) {
      if (minority[i] == few) turned.push_back(i);
    }
  }
  change.triangles += turned.size();
  for (const std::int32_t t : turned) turn(mesh.triangles[t]);
}

void turn_outwards(MeshData& mesh, WindingChange& change) {
  const MeshReview review = review_mesh(mesh);
  if (review.part_of.size() != mesh.triangles.size()) return;
  const auto& parts = review.parts;
  const auto nesting = find_nesting(review.mesh, review.part_of, parts, kTouchingTolerance * mesh_extent(review.mesh));
  const auto all_misplaced = [&](std::size_t i) { return nesting[i].misplaced > 0 && nesting[i].in_place == 0; };
  std::vector<bool> turned(parts.size());
  for (std::size_t i = 0; i < parts.size(); ++i) turned[i] = all_misplaced(i) && parts[i].volume < 0;
  // A part that faced the other way than its holder was a hollow of it, so both are turned.
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (all_misplaced(i) && parts[i].volume > 0 && nesting[i].holder) turned[i] = turned[*nesting[i].holder];
  }
  for (const bool t : turned) change.parts += t ? 1 : 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (turned[review.part_of[t]]) turn(mesh.triangles[t]);
  }
}

}  // namespace

WindingChange wind_consistently(MeshData& mesh) {
  WindingChange change;
  turn_neighbours(mesh, change);
  turn_outwards(mesh, change);
  return change;
}

}  // namespace netpocket
