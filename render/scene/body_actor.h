#pragma once
// The rigid bodies, each at its pose.

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkTransform.h>

#include "engine/state/structure.h"
#include "render/scene/palette.h"
#include "render/scene/scene_actor.h"

namespace netpocket {

class BodyActor final : public SceneActor {
 public:
  BodyActor(const Structure& structure, std::size_t body, const SceneOptions& options);

  void update(const Snapshot& snapshot) override;
  void adapt(const View& view) override;
  std::string name() const override { return structure_.bodies[body_].name; }

 private:
  const Structure& structure_;
  std::size_t body_;
  SceneOptions options_;
  vtkNew<vtkPolyData> surface_mesh_;  // empty until the first update
  vtkNew<vtkPolyData> line_mesh_;
  vtkNew<vtkTransform> pose_;
  vtkSmartPointer<vtkActor> lines_;
};

}  // namespace netpocket
