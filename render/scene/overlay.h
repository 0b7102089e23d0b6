#pragma once
// Flat shapes and texts on top of the picture, in pixels from its lower left corner.

#include <vtkActor2D.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkTextActor.h>
#include <vtkUnsignedCharArray.h>

#include <Eigen/Core>
#include <string>

#include "render/scene/color.h"

namespace netpocket {

class OverlayShapes {
 public:
  OverlayShapes();

  void clear();
  void add_rectangle(const Eigen::Vector2d& low, const Eigen::Vector2d& high, const Color& color);
  void add_line(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double width, const Color& color);
  void add_triangle(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c, const Color& color);

  vtkActor2D* prop() { return actor_; }

 private:
  void add_polygon(std::initializer_list<Eigen::Vector2d> corners, const Color& color);

  vtkNew<vtkPolyData> mesh_;
  vtkNew<vtkPoints> points_;
  vtkNew<vtkCellArray> polygons_;
  vtkNew<vtkUnsignedCharArray> colors_;
  vtkNew<vtkActor2D> actor_;
};

enum class Align { left, center, right };

class OverlayText {
 public:
  OverlayText(const Color& color, Align align, bool bold = false);

  // Lets little of what is behind shine through.
  void set_ground(const Color& color);
  // In DejaVu Sans or, for letters that it lacks, another installed font.
  void set_text(const std::string& text);
  // The middle of the text's height, its left end, middle or right end; size in pixels.
  void place(const Eigen::Vector2d& position, double size);
  // Likewise, but no wider than `width` pixels: in smaller letters, and where that is not enough without its end.
  void place_within(const Eigen::Vector2d& position, double size, double width);

  vtkTextActor* prop() { return actor_; }

 private:
  double width_of(const std::string& text) const;

  vtkNew<vtkTextActor> actor_;
  bool bold_;
  std::string text_;  // all of it
};

}  // namespace netpocket
