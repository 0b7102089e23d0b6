#pragma once
// Cords of one look as lines in one mesh: net cords are far thinner than a pixel at the scale of a pocket.

#include <vtkActor.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

#include "render/scene/color_scale.h"
#include "render/scene/element_curve.h"
#include "render/scene/scene_actor.h"

namespace netpocket {

struct CordStyle {
  std::string name;
  std::vector<CableLook> looks;  // the elements that are drawn
  Color color;                   // unless the scale colours them
  double width = 1;              // pixels of a picture 720 pixels high
  double smallest_width = 1;     // pixels
  Color distance_color;          // what the far side of the pocket fades to
  double fading = 0;             // how much of it at the farthest place, 0 to 1
  double nearer = 0;             // drawn in front of other cords at the same place by this fraction of the depth
  int segments = 3;              // straight pieces of an element
};

class CordActor final : public SceneActor {
 public:
  CordActor(const Structure& structure, const ColorScale& scale, const CordStyle& style);

  void update(const Snapshot& snapshot) override;
  void adapt(const View& view) override;
  std::string name() const override { return style_.name; }

 private:
  const Structure& structure_;
  const ColorScale& scale_;
  CordStyle style_;
  ElementCurve curve_;
  std::vector<std::size_t> elements_;  // indices into Structure::elements
  bool scaled_ = false;
  vtkNew<vtkFloatArray> positions_;
  vtkNew<vtkUnsignedCharArray> colors_;
  vtkNew<vtkPolyData> mesh_;
  vtkNew<vtkPolyData> joint_mesh_;  // the same points
  vtkSmartPointer<vtkActor> actor_, joints_;
};

}  // namespace netpocket
