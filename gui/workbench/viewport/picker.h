#pragma once
// What lies under the mouse: computed from the state that is shown, so it needs no OpenGL and any thread may ask.

#include <Eigen/Core>
#include <cstdint>
#include <optional>

#include "gui/workbench/viewport/orbit_camera.h"
#include "gui/workbench/viewport/view_state.h"

namespace netpocket {

enum class PickKind { node, element, body };

// Something in a structure; stays meaningful while the state changes.
struct Pick {
  PickKind kind = PickKind::node;
  std::int32_t index = 0;          // node, element or body
  double fraction = 0;             // along the element
  Eigen::Vector3d local{0, 0, 0};  // point of the body, body axes, m

  bool operator==(const Pick&) const = default;
};

// The node, cord or body that is seen at a position: things in front win, cords are caught within a few pixels.
std::optional<Pick> pick_at(const ViewState& state, const QPointF& position, const QSizeF& size);

// The body that is seen at a position, whatever cords are in front of it.
std::optional<Pick> body_at(const ViewState& state, const QPointF& position, const QSizeF& size);

// Where it is in a snapshot, m, world; nothing when it does not exist there.
std::optional<Eigen::Vector3d> position_of(const Pick& pick, const Structure& structure, const Snapshot& snapshot);

}  // namespace netpocket
