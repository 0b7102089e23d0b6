#include "render/scene/pocket_scene.h"

#include <vtkCommand.h>

#include "render/scene/axes_triad.h"
#include "render/scene/body_actor.h"
#include "render/scene/cord_actor.h"
#include "render/scene/joint_actor.h"
#include "render/scene/legend.h"
#include "render/scene/palette.h"
#include "render/scene/rod_actor.h"
#include "render/scene/rope_line_actor.h"
#include "render/scene/scale_bar.h"
#include "render/scene/time_label.h"

namespace netpocket {
namespace {

CordStyle net_style(const SceneOptions& options) {
  const auto& colors = palette(options.background);
  return {.name = "net",
          .looks = {CableLook::cord},
          .color = colors.net,
          .width = 1.2 * options.line_scale,
          .smallest_width = 0.9,
          .distance_color = colors.background,
          .fading = 0.55,
          .segments = 3};
}

CordStyle closing_rope_style(const SceneOptions& options) {
  const auto& colors = palette(options.background);
  return {.name = "closing ropes",
          .looks = {CableLook::rope},
          .color = colors.closing_ropes,
          .width = 3.0 * options.line_scale,
          .smallest_width = 2.0,
          .distance_color = colors.background,
          .fading = 0.3,
          .nearer = 0.004,  // than the net's edge, which lies along the ropes
          .segments = 6};
}

}  // namespace

PocketScene::PocketScene(const Structure& structure, const SceneOptions& options,
                         const vtkSmartPointer<vtkRenderer>& renderer)
    : structure_(structure),
      options_(options),
      scale_(structure_, options_),
      arrow_scale_(options_),
      renderer_(renderer ? renderer : vtkSmartPointer<vtkRenderer>::New()) {
  const auto& colors = palette(options_.background);
  renderer_->SetBackground(colors.background.data());
  renderer_->SetBackground2(colors.background_top.data());
  renderer_->SetGradientBackground(colors.background != colors.background_top && !options_.transparent_background);
  renderer_->SetBackgroundAlpha(options_.transparent_background ? 0 : 1);
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
  if (!structure_.nodes(NodeLook::rope).empty()) {
    actors_.push_back(std::make_unique<RopeLineActor>(structure_, closing_rope_style(options_)));
  }
  if (options_.contact_arrows) actors_.push_back(std::make_unique<ContactArrows>(arrow_scale_, options_));
  if (options_.ghost) {
    auto ghost = std::make_unique<GhostActor>(structure_, options_);
    ghost_ = ghost.get();
    actors_.push_back(std::move(ghost));
  }
  if (options_.trails) {
    auto trails = std::make_unique<TrailActor>(structure_, options_);
    trails_ = trails.get();
    actors_.push_back(std::move(trails));
  }
}

void PocketScene::add_annotations() {
  const auto& colors = palette(options_.background);
  first_annotation_ = actors_.size();
  actors_.push_back(std::make_unique<TimeLabel>(options_, colors.text));
  if (options_.scale_bar) actors_.push_back(std::make_unique<ScaleBar>(options_, colors.text));
  if (options_.contact_arrows) actors_.push_back(std::make_unique<ArrowLegend>(arrow_scale_, options_));
  if (options_.axes) actors_.push_back(std::make_unique<AxesTriad>(options_, colors.text));
  if (options_.legend && scale_.active()) actors_.push_back(std::make_unique<Legend>(scale_, options_, colors.text));
}

void PocketScene::update(const Snapshot& snapshot) {
  scale_.update(snapshot);
  for (const auto& actor : actors_) actor->update(snapshot);
}

void PocketScene::set_history(const SceneHistory& history) {
  if (ghost_) ghost_->set_history(history);
  if (trails_) trails_->set_history(history);
}

void PocketScene::show_annotations(bool visible) {
  for (auto i = first_annotation_; i < actors_.size(); ++i) {
    for (const auto& prop : actors_[i]->props()) prop->SetVisibility(visible);
  }
}

std::vector<SceneObject> PocketScene::objects() const {
  std::vector<SceneObject> objects;
  for (std::size_t i = 0; i < first_annotation_; ++i) {
    for (const auto& prop : actors_[i]->props()) {
      auto* actor = vtkActor::SafeDownCast(prop);
      if (actor && actor->GetVisibility()) objects.push_back({actors_[i]->name(), actor});
    }
  }
  return objects;
}

void PocketScene::prepare_drawing() {
  renderer_->ResetCameraClippingRange();
  const int* size = renderer_->GetSize();
  const View view{size[0], size[1], renderer_->GetActiveCamera()};
  for (const auto& actor : actors_) actor->adapt(view);
}

}  // namespace netpocket
