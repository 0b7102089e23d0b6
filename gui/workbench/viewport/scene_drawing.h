#pragma once
// Draws view states in an OpenGL context: what both presenters share.
// Thread contract: the host's thread, from the making to the end.

#include <memory>
#include <optional>

#include "gui/workbench/viewport/view_state.h"
#include "render/gl/hosted_render_window.h"
#include "render/scene/pocket_scene.h"

namespace netpocket {

class SceneDrawing {
 public:
  explicit SceneDrawing(std::shared_ptr<GlHost> host);
  ~SceneDrawing();
  SceneDrawing(const SceneDrawing&) = delete;
  SceneDrawing& operator=(const SceneDrawing&) = delete;

  // Draws into the window's own framebuffer; size in device pixels. Only what differs from the state before is changed.
  void draw(const ViewState& state, int width, int height);

  HostedRenderWindow& window() { return *window_; }

 private:
  void build_scene(const ViewState& state);

  vtkSmartPointer<HostedRenderWindow> window_;
  vtkSmartPointer<vtkRenderer> renderer_;
  std::unique_ptr<PocketScene> scene_;
  ViewState shown_;
};

}  // namespace netpocket
