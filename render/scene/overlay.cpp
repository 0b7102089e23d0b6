#include "render/scene/overlay.h"

#include <vtkCellData.h>
#include <vtkCoordinate.h>
#include <vtkPoints.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkTextProperty.h>
#include <vtkTextRenderer.h>

#include <algorithm>
#include <cmath>

#include "render/fonts/drawable_text.h"
#include "render/fonts/shortened.h"

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

OverlayText::OverlayText(const Color& color, Align align, bool bold) : bold_(bold) {
  auto* property = actor_->GetTextProperty();
  property->SetFontFamily(VTK_FONT_FILE);
  property->SetFontFile(font_file({.bold = bold}).c_str());
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

void OverlayText::set_text(const std::string& text) {
  const DrawableText drawable = drawable_text(text, {.bold = bold_});
  text_ = drawable.text;
  actor_->GetTextProperty()->SetFontFile(drawable.font.c_str());
  actor_->SetInput(text_.c_str());
}

void OverlayText::place(const Eigen::Vector2d& position, double size) {
  actor_->SetPosition(std::round(position.x()), std::round(position.y()));
  actor_->GetTextProperty()->SetFontSize(static_cast<int>(std::lround(size)));
}

void OverlayText::place_within(const Eigen::Vector2d& position, double size, double width) {
  constexpr double kSmallest = 0.7;
  place(position, size);
  const double needed = width_of(text_);
  if (needed > width) place(position, std::floor(size * std::max(kSmallest, width / needed)));
  actor_->SetInput(shortened(text_, [&](const std::string& part) { return width_of(part) <= width; }).c_str());
}

double OverlayText::width_of(const std::string& text) const {
  constexpr int kDotsPerInch = 72;  // of every render window that is not told otherwise
  int box[4] = {0, 0, 0, 0};
  vtkTextRenderer::GetInstance()->GetBoundingBox(actor_->GetTextProperty(), text, box, kDotsPerInch);
  return box[1] - box[0] + 1;
}

}  // namespace netpocket
