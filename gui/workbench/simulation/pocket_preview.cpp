#include "gui/workbench/simulation/pocket_preview.h"

#include "engine/systems/capture_system.h"

namespace netpocket {
namespace {

Snapshot snapshot_at_rest(const Model& model) {
  Snapshot snapshot;
  snapshot.positions.resize(3, static_cast<Eigen::Index>(model.nodes.size()));
  snapshot.velocities.resizeLike(snapshot.positions);
  for (Eigen::Index i = 0; const ModelNode& node : model.nodes) {
    snapshot.positions.col(i) = node.position;
    snapshot.velocities.col(i++) = node.velocity;
  }
  snapshot.gradients.resize(3, static_cast<Eigen::Index>(model.gradients.size()));
  for (Eigen::Index i = 0; const ModelGradient& gradient : model.gradients) {
    snapshot.gradients.col(i++) = gradient.value;
  }
  snapshot.tension.setZero(static_cast<Eigen::Index>(model.elements.size()));
  snapshot.strain.setZero(snapshot.tension.size());
  for (const VariableRope& rope : model.ropes) {
    snapshot.rope_element_length.push_back(rope.motion.length / static_cast<double>(rope.elements.size()));
  }
  for (const ModelBody& body : model.bodies) snapshot.bodies.push_back(body.state);
  return snapshot;
}

}  // namespace

PocketPreview preview_pocket(const Scenario& scenario) {
  const CaptureSystem system = build_capture_system(scenario);
  return {std::make_shared<const Structure>(system.structure),
          std::make_shared<const Snapshot>(snapshot_at_rest(system.model))};
}

}  // namespace netpocket
