#pragma once
// Decides which elements of a model can touch each other. Excluded are
// - elements that share a node, or are joined by so little cord that they lie within each other's thickness, as at
//   knots and where cords are tied to rods;
// - elements of two threads that overlap as built, such as a closing rope along the mouth's edge. The two are one cord,
//   reeved through each other's loops;
// - elements without thickness, and pairs in which neither element can move.

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "engine/dynamics/contact/cord_polyline.h"
#include "engine/model/model.h"

namespace netpocket {

class CordPairs {
 public:
  CordPairs(const Model& model, const CordPolyline& polyline, const CoordinateVectors& coordinates,
            std::span<const double> inverse_mass);

  bool may_touch(std::int32_t first, std::int32_t second) const;

 private:
  using ThreadPair = std::pair<std::int32_t, std::int32_t>;  // smaller first

  const Model& model_;
  // Elements near along the cords that share no node. Those of element i are neighbours_[first_neighbour_[i]] to
  // neighbours_[first_neighbour_[i + 1] - 1], sorted.
  std::vector<std::int32_t> neighbours_, first_neighbour_ = {0};
  std::vector<std::uint8_t> solid_;         // by element: whether it has thickness
  std::vector<std::uint8_t> moves_;         // by element: whether any of its coordinates is free
  std::vector<ThreadPair> joined_threads_;  // sorted
};

}  // namespace netpocket
