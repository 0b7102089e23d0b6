#include "render/scene/pocket_scene.h"

#include <vtkCommand.h>

#include "render/scene/axes_triad.h"
#include "render/scene/body_actor.h"
#include "render/scene/cord_actor.h"
#include "render/scene/joint_actor.h"
#include "render/scene/legend.h"
#include "render/scene/palette.h"
#include "render/scene/rod_actor.h"
#include "render/scene/scale_bar.h"
#include "render/scene/time_label.h"

namespace netpocket {
namespace {

CordStyle net_style(const SceneOptions& options) {
  const auto& colors = palette(options.background);
  return {.kinds = {ElementKind::net, ElementKind::cable},
          .color = colors.net,
          .width = 1.2 * options.line_scale,
          .smallest_width = 0.9,
          .distance_color = colors.background,
          .fading = 0.55,
          .segments = 3};
}

CordStyle closing_rope_style(const SceneOptions& options) {
  const auto& colors = palette(options.background);
  return {.kinds = {ElementKind::closing_rope},
          .color = colors.closing_ropes,
          .width = 3.0 * options.line_scale,
          .smallest_width = 2.0,
          .distance_color = colors.background,
          .fading = 0.3,
          .nearer = 0.004,  // than the net's edge, which lies along the ropes
          .segments = 6};
}

}  // namespace

PocketScene::PocketScene(const Structure& structure, const SceneOptions& options, vtkSmartPointer<vtkRenderer> renderer)
    : structure_(structure),
      options_(options),
      scale_(structure_, options_),
      renderer_(renderer ? renderer : vtkSmartPointer<vtkRenderer>::New()) {
  const auto& colors = palette(options_.background);
  renderer_->SetBackground(colors.background.data());
  renderer_->SetBackground2(colors.background_top.data());
  renderer_->SetGradientBackground(colors.background != colors.background_top);
  renderer_->SetUseFXAA(options_.fast_smoothing);
  add_actors();
  add_annotations();
  for (const auto& actor : actors_) {
    for (const auto& prop : actor->props()) renderer_->AddViewProp(prop);
  }
  start_observer_ = renderer_->AddObserver(vtkCommand::StartEvent, this, &PocketScene::prepare_drawing);
}

PocketScene::~PocketScene() {
  renderer_->RemoveObserver(start_observer_);
  for (const auto& actor : actors_) {
    for (const auto& prop : actor->props()) renderer_->RemoveViewProp(prop);
  }
}

void PocketScene::add_actors() {
  for (std::size_t i = 0; i < structure_.bodies.size(); ++i) {
    actors_.push_back(std::make_unique<BodyActor>(structure_, i, options_));
  }
  actors_.push_back(std::make_unique<RodActor>(structure_, scale_, options_));
  actors_.push_back(std::make_unique<JointActor>(structure_, options_.background));
  actors_.push_back(std::make_unique<CordActor>(structure_, scale_, net_style(options_)));
  actors_.push_back(std::make_unique<CordActor>(structure_, scale_, closing_rope_style(options_)));
}

void PocketScene::add_annotations() {
  const auto& colors = palette(options_.background);
  first_annotation_ = actors_.size();
  actors_.push_back(std::make_unique<TimeLabel>(options_, colors.text));
  if (options_.scale_bar) actors_.push_back(std::make_unique<ScaleBar>(options_, colors.text));
  if (options_.axes) actors_.push_back(std::make_unique<AxesTriad>(options_, colors.text));
  if (options_.legend && scale_.active()) actors_.push_back(std::make_unique<Legend>(scale_, options_, colors.text));
}

void PocketScene::update(const Snapshot& snapshot) {
  scale_.widen(snapshot);
  for (const auto& actor : actors_) actor->update(snapshot);
}

void PocketScene::show_annotations(bool visible) {
  for (auto i = first_annotation_; i < actors_.size(); ++i) {
    for (const auto& prop : actors_[i]->props()) prop->SetVisibility(visible);
  }
}

void PocketScene::prepare_drawing() {
  renderer_->ResetCameraClippingRange();
  const int* size = renderer_->GetSize();
  const View view{size[0], size[1], renderer_->GetActiveCamera()};
  for (const auto& actor : actors_) actor->adapt(view);
}

}  // namespace netpocket
