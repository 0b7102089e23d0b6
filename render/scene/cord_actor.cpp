#include "render/scene/cord_actor.h"

#include <vtkCellArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkProperty.h>

#include <algorithm>

#include "render/scene/depth_fading.h"
#include "render/scene/surface_props.h"

namespace netpocket {
namespace {

// Where wide lines bend, a notch is left between their pieces; it is filled when it can be seen.
constexpr double kNotchedWidth = 4;  // pixels
// Diameter of what fills it: OpenGL measures a line's width along the picture's rows or columns, so that one at 45
// degrees is that much thinner.
constexpr double kFilling = 0.7;  // of the width

}  // namespace

CordActor::CordActor(const Structure& structure, const ColorScale& scale, const CordStyle& style)
    : structure_(structure), scale_(scale), style_(style), curve_(style.segments) {
  for (std::size_t i = 0; i < structure.elements.size(); ++i) {
    const CableLook look = structure.look_of(structure.elements[i]);
    if (std::ranges::find(style_.looks, look) == style_.looks.end()) continue;
    elements_.push_back(i);
    scaled_ = scale.colors(look);
  }
  const int points_each = curve_.point_count();
  const auto point_count = static_cast<vtkIdType>(elements_.size()) * points_each;
  positions_->SetNumberOfComponents(3);
  positions_->SetNumberOfTuples(point_count);
  positions_->FillValue(0);
  vtkNew<vtkPoints> points;
  points->SetData(positions_);
  mesh_->SetPoints(points);

  vtkNew<vtkCellArray> lines, dots;
  for (vtkIdType first = 0; first < point_count; first += points_each) {
    lines->InsertNextCell(points_each);
    for (int i = 0; i < points_each; ++i) lines->InsertCellPoint(first + i);
  }
  for (vtkIdType point = 0; point < point_count; ++point) dots->InsertNextCell({point});
  mesh_->SetLines(lines);
  joint_mesh_->SetPoints(points);
  joint_mesh_->SetVerts(dots);
  if (scaled_) {
    colors_->SetNumberOfComponents(3);
    colors_->SetNumberOfTuples(point_count);
    mesh_->GetPointData()->SetScalars(colors_);
    joint_mesh_->GetPointData()->SetScalars(colors_);
  }
  actor_ = make_lines(mesh_, style_.color);
  joints_ = make_dots(joint_mesh_, style_.color);
  props_ = {actor_, joints_};
  if (style_.fading == 0) return;
  for (const auto& actor : {actor_, joints_}) add_depth_fading(*actor, style_.distance_color, style_.nearer);
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
  joint_mesh_->Modified();
}

void CordActor::adapt(const View& view) {
  const double width = std::max(style_.width * view.scale(), style_.smallest_width);
  actor_->GetProperty()->SetLineWidth(static_cast<float>(width));
  joints_->GetProperty()->SetPointSize(static_cast<float>(kFilling * width));
  joints_->SetVisibility(actor_->GetVisibility() && width >= kNotchedWidth);
  if (style_.fading == 0) return;
  for (const auto& actor : {actor_, joints_}) set_depth_fading(*actor, *view.camera, style_.fading);
}

}  // namespace netpocket
