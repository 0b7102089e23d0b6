#include "render/scene/overlay.h"

#include <vtkCellData.h>
#include <vtkCoordinate.h>
#include <vtkPoints.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkTextProperty.h>

#include <cmath>

#include "render/fonts/font_file.h"

namespace netpocket {

OverlayShapes::OverlayShapes() {
  colors_->SetNumberOfComponents(3);
  mesh_->SetPoints(points_);
  mesh_->SetPolys(polygons_);
  mesh_->GetCellData()->SetScalars(colors_);
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(mesh_);
  mapper->SetColorModeToDirectScalars();
  actor_->SetMapper(mapper);
}

void OverlayShapes::clear() {
  points_->Reset();
  polygons_->Reset();
  colors_->Reset();
}

void OverlayShapes::add_polygon(std::initializer_list<Eigen::Vector2d> corners, const Color& color) {
  polygons_->InsertNextCell(static_cast<int>(corners.size()));
  for (const auto& corner : corners) polygons_->InsertCellPoint(points_->InsertNextPoint(corner.x(), corner.y(), 0));
  colors_->InsertNextTypedTuple(to_bytes(color).data());
  points_->Modified();
  polygons_->Modified();
  colors_->Modified();
  mesh_->Modified();
}

void OverlayShapes::add_rectangle(const Eigen::Vector2d& low, const Eigen::Vector2d& high, const Color& color) {
  add_polygon({low, {high.x(), low.y()}, high, {low.x(), high.y()}}, color);
}

void OverlayShapes::add_line(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double width, const Color& color) {
  const Eigen::Vector2d along = to - from;
  if (along.norm() == 0) return;
  const Eigen::Vector2d side = Eigen::Vector2d(-along.y(), along.x()) * (width / 2 / along.norm());
  add_polygon({from - side, to - side, to + side, from + side}, color);
}

void OverlayShapes::add_triangle(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c,
                                 const Color& color) {
  add_polygon({a, b, c}, color);
}

namespace {

void use_scene_font(vtkTextProperty& property, bool bold) {
  property.SetFontFamily(VTK_FONT_FILE);
  property.SetFontFile(font_file(bold).c_str());
}

}  // namespace

OverlayText::OverlayText(const Color& color, Align align, bool bold) {
  auto* property = actor_->GetTextProperty();
  use_scene_font(*property, bold);
  property->SetColor(color[0], color[1], color[2]);
  property->SetVerticalJustificationToCentered();
  property->SetJustification(align == Align::left     ? VTK_TEXT_LEFT
                             : align == Align::center ? VTK_TEXT_CENTERED
                                                      : VTK_TEXT_RIGHT);
  actor_->SetTextScaleModeToNone();
  actor_->GetPositionCoordinate()->SetCoordinateSystemToViewport();
}

void OverlayText::set_ground(const Color& color) {
  constexpr double kOpacity = 0.85;
  actor_->GetTextProperty()->SetBackgroundColor(color[0], color[1], color[2]);
  actor_->GetTextProperty()->SetBackgroundOpacity(kOpacity);
}

void OverlayText::set_text(const std::string& text) { actor_->SetInput(text.c_str()); }

void OverlayText::place(const Eigen::Vector2d& position, double size) {
  actor_->SetPosition(std::round(position.x()), std::round(position.y()));
  actor_->GetTextProperty()->SetFontSize(static_cast<int>(std::lround(size)));
}

}  // namespace netpocket
