#pragma once
// Polylines for the contact of cords: each element is a chain of straight capsules through points of its curve. The
// chain ends at the element's nodes. So cords are closed chains, and nothing slips through between two capsules.

#include <Eigen/Core>
#include <array>
#include <vector>

#include "engine/ancf/shape_functions.h"
#include "engine/bodies/segment_distance.h"
#include "engine/dynamics/assembly/coordinate_vectors.h"
#include "engine/dynamics/assembly/element_curve.h"
#include "engine/model/model.h"

namespace netpocket {

class CordPolyline {
 public:
  static constexpr int kSegments = 4;
  using Vertices = std::array<Eigen::Vector3d, kSegments + 1>;
  using Weights = ElementWeights;

  CordPolyline(const Model& model, const CoordinateLayout& layout) : model_(model), layout_(layout) {
    for (std::size_t i = 0; i < unit_weights_.size(); ++i) {
      const NodalWeights weights = shape(2.0 * static_cast<double>(i) / kSegments - 1, 1.0);
      unit_weights_[i] = {weights[0], weights[1], weights[2], weights[3]};
    }
  }

  ElementIndices indices(std::int32_t index) const {
    const ModelElement& element = model_.elements[static_cast<std::size_t>(index)];
    return {layout_.position(element.node1), layout_.gradient(element.gradient1), layout_.position(element.node2),
            layout_.gradient(element.gradient2)};
  }
  // Shape functions at a vertex of an element of `length` (m).
  Weights weights(int vertex, double length) const {
    const Weights& unit = unit_weights_[static_cast<std::size_t>(vertex)];
    return {unit[0], length * unit[1], unit[2], length * unit[3]};
  }
  // A vertex (m) from coordinates, or its velocity (m/s) from velocities.
  Eigen::Vector3d vertex(const CoordinateVectors& vectors, double length, std::int32_t element, int vertex) const {
    return combine(vectors, indices(element), weights(vertex, length));
  }
  Vertices vertices(const CoordinateVectors& coordinates, double length, std::int32_t element) const {
    Vertices result;
    for (int i = 0; i <= kSegments; ++i) result[static_cast<std::size_t>(i)] = vertex(coordinates, length, element, i);
    return result;
  }

 private:
  const Model& model_;
  CoordinateLayout layout_;
  std::array<Weights, kSegments + 1> unit_weights_;  // by vertex, for unit length
};

}  // namespace netpocket
