#include "render/scene/cord_actor.h"

#include <vtkCellArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkProperty.h>

#include <algorithm>

#include "render/scene/depth_fading.h"
#include "render/scene/surface_props.h"

namespace netpocket {

CordActor::CordActor(const Structure& structure, const ColorScale& scale, const CordStyle& style)
    : structure_(structure), scale_(scale), style_(style), curve_(style.segments) {
  for (std::size_t i = 0; i < structure.elements.size(); ++i) {
    const auto kind = structure.elements[i].kind;
    if (std::ranges::find(style_.kinds, kind) == style_.kinds.end()) continue;
    elements_.push_back(i);
    scaled_ = scale.colors(kind);
  }
  const int points_each = curve_.point_count();
  const auto point_count = static_cast<vtkIdType>(elements_.size()) * points_each;
  positions_->SetNumberOfComponents(3);
  positions_->SetNumberOfTuples(point_count);
  positions_->FillValue(0);
  vtkNew<vtkPoints> points;
  points->SetData(positions_);
  mesh_->SetPoints(points);

  vtkNew<vtkCellArray> lines;
  for (vtkIdType first = 0; first < point_count; first += points_each) {
    lines->InsertNextCell(points_each);
    for (int i = 0; i < points_each; ++i) lines->InsertCellPoint(first + i);
  }
  mesh_->SetLines(lines);
  if (scaled_) {
    colors_->SetNumberOfComponents(3);
    colors_->SetNumberOfTuples(point_count);
    mesh_->GetPointData()->SetScalars(colors_);
  }
  actor_ = make_lines(mesh_, style_.color);
  if (style_.fading > 0) add_depth_fading(*actor_, style_.distance_color, style_.nearer);
  props_ = {actor_};
}

void CordActor::update(const Snapshot& snapshot) {
  float* position = positions_->GetPointer(0);
  unsigned char* color = scaled_ ? colors_->GetPointer(0) : nullptr;
  for (const std::size_t index : elements_) {
    const auto& element = structure_.elements[index];
    for (int i = 0; i < curve_.point_count(); ++i) {
      Eigen::Map<Eigen::Vector3f>{position} = curve_.position(snapshot, element, i).cast<float>();
      position += 3;
      if (!color) continue;
      color = std::ranges::copy(to_bytes(scale_.color(scale_.value(snapshot, index, curve_.fraction(i)))), color).out;
    }
  }
  positions_->Modified();
  mesh_->GetPoints()->Modified();
  if (scaled_) colors_->Modified();
  mesh_->Modified();
}

void CordActor::adapt(const View& view) {
  const double width = std::max(style_.width * view.scale(), style_.smallest_width);
  actor_->GetProperty()->SetLineWidth(static_cast<float>(width));
  if (style_.fading > 0) set_depth_fading(*actor_, *view.camera, style_.fading);
}

}  // namespace netpocket
