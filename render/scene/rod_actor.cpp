#include "render/scene/rod_actor.h"

#include <vtkCellArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "render/scene/palette.h"
#include "render/scene/surface_props.h"

namespace netpocket {
namespace {

constexpr int kSides = 12;
constexpr int kSegments = 2;  // of an element

// The cosines and sines of a ring's points.
const Eigen::Matrix<double, 2, kSides>& ring() {
  static const auto points = [] {
    Eigen::Matrix<double, 2, kSides> matrix;
    for (int i = 0; i < kSides; ++i) {
      const double angle = 2 * std::numbers::pi * i / kSides;
      matrix.col(i) << std::cos(angle), std::sin(angle);
    }
    return matrix;
  }();
  return points;
}

std::vector<std::vector<std::size_t>> smooth_chains(const Structure& structure) {
  std::vector<std::vector<std::size_t>> chains;
  const StructureElement* previous = nullptr;
  for (std::size_t i = 0; i < structure.elements.size(); ++i) {
    const auto& element = structure.elements[i];
    if (structure.look_of(element) != CableLook::tube) continue;
    const bool continues = previous && previous->gradient[1] == element.gradient[0];
    if (!continues) chains.emplace_back();
    chains.back().push_back(i);
    previous = &element;
  }
  return chains;
}

}  // namespace

RodActor::RodActor(const Structure& structure, const ColorScale& scale, const SceneOptions& options)
    : structure_(structure), scale_(scale), curve_(kSegments), tubes_(smooth_chains(structure)) {
  vtkNew<vtkCellArray> quads;
  vtkIdType ring_count = 0;
  for (const auto& tube : tubes_) {
    const auto rings = static_cast<vtkIdType>(tube.size()) * kSegments + 1;
    add_tube(ring_count, rings, *quads);
    ring_count += rings;
  }
  for (auto* array : {positions_.Get(), normals_.Get()}) {
    array->SetNumberOfComponents(3);
    array->SetNumberOfTuples(ring_count * kSides);
    array->FillValue(0);
  }
  vtkNew<vtkPoints> points;
  points->SetData(positions_);
  mesh_->SetPoints(points);
  mesh_->SetPolys(quads);
  mesh_->GetPointData()->SetNormals(normals_);
  if (scale.colors(CableLook::tube)) {
    colors_->SetNumberOfComponents(3);
    colors_->SetNumberOfTuples(ring_count * kSides);
    mesh_->GetPointData()->SetScalars(colors_);
  }
  props_ = {make_surface(mesh_, options.background, palette(options.background).rods)};
}

void RodActor::add_tube(vtkIdType first_ring, vtkIdType ring_count, vtkCellArray& quads) {
  for (vtkIdType ring = first_ring; ring + 1 < first_ring + ring_count; ++ring) {
    for (vtkIdType side = 0; side < kSides; ++side) {
      const vtkIdType a = ring * kSides + side, b = ring * kSides + (side + 1) % kSides;
      quads.InsertNextCell({a, b, b + kSides, a + kSides});
    }
  }
}

void RodActor::place_ring(const CurvePoint& center, double radius) {
  const Eigen::Vector3d axis = center.tangent.normalized();
  const Eigen::Vector3d projected = across_ - across_.dot(axis) * axis;
  across_ = projected.norm() > 1e-6 ? projected.normalized() : axis.unitOrthogonal();
  const Eigen::Vector3d other = axis.cross(across_);
  for (int side = 0; side < kSides; ++side, ++next_point_) {
    const Eigen::Vector3d normal = ring()(0, side) * across_ + ring()(1, side) * other;
    Eigen::Map<Eigen::Vector3f>(normals_->GetPointer(3 * next_point_)) = normal.cast<float>();
    Eigen::Map<Eigen::Vector3f>(positions_->GetPointer(3 * next_point_)) =
        (center.position + radius * normal).cast<float>();
  }
}

void RodActor::update(const Snapshot& snapshot) {
  next_point_ = 0;
  for (const auto& tube : tubes_) {
    across_.setZero();
    for (const std::size_t index : tube) {
      const auto& element = structure_.elements[index];
      // Neighbours share the ring between them.
      for (int i = index == tube.front() ? 0 : 1; i < curve_.point_count(); ++i) {
        if (scale_.colors(CableLook::tube)) {
          const auto color = to_bytes(scale_.color(scale_.value(snapshot, index, curve_.fraction(i))));
          for (int side = 0; side < kSides; ++side) colors_->SetTypedTuple(next_point_ + side, color.data());
        }
        place_ring(curve_.at(snapshot, element, i), element.radius);
      }
    }
  }
  positions_->Modified();
  normals_->Modified();
  colors_->Modified();
  mesh_->GetPoints()->Modified();
  mesh_->Modified();
}

}  // namespace netpocket
