#pragma once
// The forces of contacts on the bodies: arrows that end at the places they act on, and what their length means.

#include <vtkActor.h>

#include <memory>

#include "render/scene/overlay.h"
#include "render/scene/repeated_mesh.h"
#include "render/scene/scene_actor.h"
#include "render/scene/scene_options.h"

namespace netpocket {

// From a force to the length of its arrow: in proportion, up to a largest force; all larger ones look alike.
class ArrowScale {
 public:
  explicit ArrowScale(const DisplayOptions& options);

  // Unless the options fix the largest force: makes it hold the snapshot's contacts, up to a round number.
  void update(const Snapshot& snapshot);

  double largest_force() const { return largest_force_; }    // N
  double largest_length() const { return largest_length_; }  // m, a fixed share of the pocket's size
  double length(double force) const;                         // m

 private:
  bool fixed_;
  double largest_force_;
  double largest_length_ = 0;
};

// The size of a contact's force that one contact in fifty exceeds, N; 0 without contacts.
double high_contact_force(const Snapshot& snapshot);

class ContactArrows final : public SceneActor {
 public:
  ContactArrows(ArrowScale& scale, const SceneOptions& options);

  void update(const Snapshot& snapshot) override;
  std::string name() const override { return "contact forces"; }

 private:
  void make_room(std::size_t arrows);

  ArrowScale& scale_;
  vtkSmartPointer<vtkPolyData> arrow_;  // of unit length along z, its tip at the origin
  std::unique_ptr<RepeatedMesh> arrows_;
  std::size_t room_ = 0;
  vtkSmartPointer<vtkActor> actor_;
};

// An arrow of the largest length, above the scale bar.
class ArrowLegend final : public SceneActor {
 public:
  ArrowLegend(const ArrowScale& scale, const SceneOptions& options);

  void adapt(const View& view) override;

 private:
  const ArrowScale& scale_;
  SceneOptions options_;
  OverlayShapes arrow_;
  OverlayText label_;
};

}  // namespace netpocket
