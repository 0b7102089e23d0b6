#pragma once
// Ropes that are not made of elements, which run straight from one node of a group to the next (NodeLook::rope): a
// drawstring through rings, a tether on a drum. Slack ones are drawn straight as well.

#include <vtkActor.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <vector>

#include "engine/state/structure.h"
#include "render/scene/cord_actor.h"
#include "render/scene/scene_actor.h"

namespace netpocket {

class RopeLineActor final : public SceneActor {
 public:
  // Of `style`: name, colour, widths and fading.
  RopeLineActor(const Structure& structure, const CordStyle& style);

  void update(const Snapshot& snapshot) override;
  void adapt(const View& view) override;
  std::string name() const override { return style_.name; }

 private:
  CordStyle style_;
  std::vector<std::int32_t> nodes_;  // by point
  vtkNew<vtkFloatArray> positions_;
  vtkNew<vtkPolyData> mesh_;
  vtkSmartPointer<vtkActor> actor_;
};

}  // namespace netpocket
