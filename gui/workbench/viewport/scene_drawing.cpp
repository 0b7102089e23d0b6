#include "gui/workbench/viewport/scene_drawing.h"

#include "render/scene/palette.h"

namespace netpocket {

SceneDrawing::SceneDrawing(std::shared_ptr<GlHost> host)
    : window_(HostedRenderWindow::make(std::move(host), 16, 16)), renderer_(vtkSmartPointer<vtkRenderer>::New()) {
  window_->AddRenderer(renderer_);
}

SceneDrawing::~SceneDrawing() {
  scene_.reset();
  window_->release_host();
}

void SceneDrawing::draw(const ViewState& state, int width, int height) {
  window_->MakeCurrent();  // another viewport's context may be
  window_->SetSize(width, height);
  const bool other_scene = state.structure != shown_.structure || state.options != shown_.options;
  if (other_scene) build_scene(state);
  const bool other_history = state.history && (other_scene || state.history != shown_.history);
  if (scene_ && other_history) scene_->set_history(*state.history);
  if (scene_ && (other_scene || other_history || state.snapshot != shown_.snapshot)) scene_->update(*state.snapshot);
  renderer_->SetUseFXAA(state.smoothed());
  apply_view(state.camera, *renderer_->GetActiveCamera());
  shown_ = state;
  window_->Render();
}

void SceneDrawing::build_scene(const ViewState& state) {
  scene_.reset();
  if (state.complete()) {
    scene_ = std::make_unique<PocketScene>(*state.structure, *state.options, renderer_);
    return;
  }
  const auto& colors = palette(state.options ? state.options->background : Background::white);
  renderer_->SetBackground(colors.background.data());
  renderer_->SetBackground2(colors.background_top.data());
}

}  // namespace netpocket
