#pragma once
// The paths of the bodies' centres of mass up to the time of the picture, in front of everything, with a dot where each
// is now.

#include <vtkActor.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <memory>

#include "render/scene/scene_actor.h"
#include "render/scene/scene_history.h"
#include "render/scene/scene_options.h"

namespace netpocket {

class TrailActor final : public SceneActor {
 public:
  TrailActor(const Structure& structure, const SceneOptions& options);

  void set_history(const SceneHistory& history);
  void update(const Snapshot& snapshot) override;
  void adapt(const View& view) override;
  std::string name() const override { return "trails"; }

 private:
  // The line and the dot of one body.
  struct Trail {
    vtkNew<vtkPolyData> line;
    vtkNew<vtkPolyData> dot;
    vtkSmartPointer<vtkActor> line_actor;
    vtkSmartPointer<vtkActor> dot_actor;
  };

  double line_scale_;
  std::vector<std::unique_ptr<Trail>> trails_;  // by Structure::bodies
  std::vector<BodyPath> paths_;
};

}  // namespace netpocket
