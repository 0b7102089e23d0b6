#pragma once
// A pocket and its bodies in a VTK renderer, drawn from snapshots. Live runs, recordings and tests use this one scene.
// Thread contract: the thread of the render window. Reads a snapshot only during update().

#include <vtkActor.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <memory>
#include <string>
#include <vector>

#include "engine/state/snapshot.h"
#include "engine/state/structure.h"
#include "render/scene/camera.h"
#include "render/scene/color_scale.h"
#include "render/scene/contact_arrows.h"
#include "render/scene/ghost_actor.h"
#include "render/scene/scene_actor.h"
#include "render/scene/scene_history.h"
#include "render/scene/scene_options.h"
#include "render/scene/trail_actor.h"

namespace netpocket {

// A part of a scene that has a place in the world.
struct SceneObject {
  std::string name;  // e.g. "net", or a body's
  vtkActor* actor;
};

class PocketScene {
 public:
  // Draws in `renderer`, or in one of its own. Other options mean another scene; the renderer and its camera may stay.
  PocketScene(const Structure& structure, const SceneOptions& options,
              const vtkSmartPointer<vtkRenderer>& renderer = nullptr);
  ~PocketScene();  // takes its props out of the renderer
  PocketScene(const PocketScene&) = delete;
  PocketScene& operator=(const PocketScene&) = delete;

  vtkRenderer& renderer() const { return *renderer_; }
  const SceneOptions& options() const { return options_; }
  const Structure& structure() const { return structure_; }

  // Shows a state; it must fit the structure. Changes points in place: no prop is made anew.
  void update(const Snapshot& snapshot);

  // What trails and ghost are drawn from; takes effect with the next update(). Fits the structure.
  void set_history(const SceneHistory& history);

  // Labels, legend, scale bar and axes.
  void show_annotations(bool visible);

  // What is drawn, without annotations, as of the last update(); valid as long as the scene.
  std::vector<SceneObject> objects() const;

  // The colours' range; grows with the snapshots unless the options fix it.
  ValueRange color_range() const { return scale_.range(); }
  // N, of the longest arrow; grows likewise.
  double arrow_force() const { return arrow_scale_.largest_force(); }

 private:
  void add_actors();
  void add_annotations();
  void prepare_drawing();

  Structure structure_;
  SceneOptions options_;
  ColorScale scale_;
  ArrowScale arrow_scale_;
  vtkSmartPointer<vtkRenderer> renderer_;
  std::vector<std::unique_ptr<SceneActor>> actors_;
  GhostActor* ghost_ = nullptr;       // among the actors, when shown
  TrailActor* trails_ = nullptr;      // likewise
  std::size_t first_annotation_ = 0;  // among the actors
  unsigned long start_observer_ = 0;
};

}  // namespace netpocket
