#pragma once
// Rods as round tubes along their bent axes; one mesh whose points move.

#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

#include "render/scene/color_scale.h"
#include "render/scene/element_curve.h"
#include "render/scene/scene_actor.h"

namespace netpocket {

class RodActor final : public SceneActor {
 public:
  RodActor(const Structure& structure, const ColorScale& scale, const SceneOptions& options);

  void update(const Snapshot& snapshot) override;
  std::string name() const override { return "rods"; }

 private:
  void add_tube(vtkIdType first_ring, vtkIdType ring_count, class vtkCellArray& quads);
  void place_ring(const CurvePoint& center, double radius);

  const Structure& structure_;
  const ColorScale& scale_;
  ElementCurve curve_;
  // Elements that continue each other without a kink.
  std::vector<std::vector<std::size_t>> tubes_;
  Eigen::Vector3d across_;  // of the ring placed last: the next one turns from it as little as possible
  vtkIdType next_point_ = 0;
  vtkNew<vtkFloatArray> positions_;
  vtkNew<vtkFloatArray> normals_;
  vtkNew<vtkUnsignedCharArray> colors_;
  vtkNew<vtkPolyData> mesh_;
};

}  // namespace netpocket
