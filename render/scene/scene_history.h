#pragma once
// What a scene shows of other moments than the one that is drawn.

#include <functional>
#include <optional>
#include <vector>

#include "engine/state/snapshot.h"
#include "engine/state/structure.h"

namespace netpocket {

// Where a body's centre of mass has been; m, world.
struct BodyPath {
  std::size_t body = 0;       // index into Structure::bodies
  std::vector<double> times;  // s, rising
  Eigen::Matrix3Xd positions;
};

struct SceneHistory {
  std::optional<Snapshot> initial;  // for the ghost
  std::vector<BodyPath> paths;      // for the trails; what is later than the picture is not drawn
};

// The paths of spacecraft and target by a run's channels: all of its times, or as far as a live run has come.
std::vector<BodyPath> body_paths(const Structure& structure,
                                 const std::function<const std::vector<double>&(Channel)>& channel);

}  // namespace netpocket
