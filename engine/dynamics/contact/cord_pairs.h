#pragma once
// Which elements of a model can touch each other at all: all but
// - those that share a node, or are joined by so little cord that they lie within each other's thickness: at knots and
//   where cords are tied to rods;
// - those of two threads that lie in one another as built, such as a closing rope along the mouth's edge: they are one
//   cord, reeved through one another's loops;
// - those without thickness, and pairs of which neither can move.

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
  // Near along the cords without sharing a node: those of element i are neighbours_[first_neighbour_[i]] to
  // neighbours_[first_neighbour_[i + 1] - 1], sorted.
  std::vector<std::int32_t> neighbours_, first_neighbour_ = {0};
  std::vector<std::uint8_t> solid_;         // by element: has thickness
  std::vector<std::uint8_t> moves_;         // by element
  std::vector<ThreadPair> joined_threads_;  // sorted
};

}  // namespace netpocket
