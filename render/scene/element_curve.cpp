#include "render/scene/element_curve.h"

#include "engine/ancf/shape_functions.h"

namespace netpocket {
namespace {

// Gradients times the element's length: then the shape functions of unit length serve every element.
ElementCoordinates unit_length_coordinates(const Snapshot& snapshot, const StructureElement& element, double length) {
  ElementCoordinates coordinates;
  coordinates.col(0) = snapshot.positions.col(element.node[0]);
  coordinates.col(1) = length * snapshot.gradients.col(element.gradient[0]);
  coordinates.col(2) = snapshot.positions.col(element.node[1]);
  coordinates.col(3) = length * snapshot.gradients.col(element.gradient[1]);
  return coordinates;
}

}  // namespace

ElementCurve::ElementCurve(int segments) {
  for (int i = 0; i <= segments; ++i) {
    const double xi = -1 + 2.0 * i / segments;
    stations_.push_back({shape(xi, 1), shape_p(xi, 1)});
  }
}

Eigen::Vector3d ElementCurve::position(const Snapshot& snapshot, const StructureElement& element, int point) const {
  const auto coordinates = unit_length_coordinates(snapshot, element, current_length(snapshot, element));
  return combine(coordinates, stations_[point].position);
}

CurvePoint ElementCurve::at(const Snapshot& snapshot, const StructureElement& element, int point) const {
  const double length = current_length(snapshot, element);
  const auto coordinates = unit_length_coordinates(snapshot, element, length);
  return {combine(coordinates, stations_[point].position), combine(coordinates, stations_[point].tangent) / length};
}

double current_length(const Snapshot& snapshot, const StructureElement& element) {
  return element.rope >= 0 ? snapshot.rope_element_length[element.rope] : element.length;
}

}  // namespace netpocket
