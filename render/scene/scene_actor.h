#pragma once
// One thing in a scene: it makes its VTK props once and then changes them in place.

#include <vtkCamera.h>
#include <vtkProp.h>
#include <vtkSmartPointer.h>

#include <string>
#include <vector>

#include "engine/state/snapshot.h"

namespace netpocket {

// The picture that is about to be drawn.
struct View {
  int width = 0;   // pixels
  int height = 0;  // pixels
  vtkCamera* camera = nullptr;

  // Pixels for one pixel of a picture 720 pixels high: lines and labels keep their share of the picture.
  double scale() const { return height / 720.0; }
};

class SceneActor {
 public:
  virtual ~SceneActor() = default;
  // Shows another state.
  virtual void update(const Snapshot&) {}
  // Called before each drawing, for what depends on the resolution or the camera.
  virtual void adapt(const View&) {}

  // What it shows, e.g. "net"; empty for annotations.
  virtual std::string name() const { return {}; }

  const std::vector<vtkSmartPointer<vtkProp>>& props() const { return props_; }

 protected:
  std::vector<vtkSmartPointer<vtkProp>> props_;
};

}  // namespace netpocket
