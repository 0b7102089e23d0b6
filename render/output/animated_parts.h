#pragma once
// Cords, rods and ropes as meshes that follow joints, for animations of a whole capture.

#include <string>
#include <vector>

#include "engine/state/snapshot.h"
#include "engine/state/structure.h"
#include "render/output/gltf_document.h"
#include "render/scene/element_curve.h"
#include "render/scene/palette.h"

namespace netpocket {

// Each node of a cord is a joint that moves without turning and carries a cross of three bars along the world's axes.
// Each element is three ribbons between the crosses at its ends. So a cord can be seen from everywhere whichever way it
// turns: its width appears as 0.58 (1/sqrt 3) or more of `width`. An element is straight.
class AnimatedCords {
 public:
  explicit AnimatedCords(const Structure& structure);

  void add_key(const Snapshot& snapshot);
  // `width`: of net cords, m; ropes are drawn twice as wide. Nothing without cords.
  void add_to(GltfDocument& document, const Palette& palette, double width) const;
  // Around all keys, m, world; empty without cords.
  const Eigen::AlignedBox3d& box() const { return box_; }

 private:
  GltfSkinnedPart part(CableLook look, double half_width) const;

  const Structure& structure_;
  std::vector<std::int32_t> nodes_;      // of the joints
  std::vector<std::uint16_t> joint_of_;  // by node
  std::vector<GltfTrack> joints_;        // by nodes_
  Eigen::AlignedBox3d box_;
};

// Ropes without elements (NodeLook::rope): a drawstring through rings, a tether on a drum. Each has a mesh of its own
// with the name of its group. Its nodes are joints that move without turning, each with an octahedron whose corners lie
// on the world's axes; between two nodes it is the straight tube that one octahedron sweeps on its way to the other. So
// it hides the cord beside which it runs. Slack ropes are straight as well: how they hang is not known.
class AnimatedRopes {
 public:
  explicit AnimatedRopes(const Structure& structure);

  void add_key(const Snapshot& snapshot);
  // `width`: of the tubes, m; it appears as 0.58 (1/sqrt 3) or more of it.
  void add_to(GltfDocument& document, const Palette& palette, double width) const;
  // Around all keys, m, world; empty without ropes.
  const Eigen::AlignedBox3d& box() const { return box_; }

 private:
  struct Rope {
    std::string name;
    std::vector<std::int32_t> nodes;
    std::vector<GltfTrack> joints;  // by nodes
  };

  std::vector<Rope> ropes_;
  Eigen::AlignedBox3d box_;
};

// Rods with their true thickness. Each ring of a tube is a joint that moves and turns with the rod's axis.
class AnimatedTubes {
 public:
  explicit AnimatedTubes(const Structure& structure);

  void add_key(const Snapshot& snapshot);
  void add_to(GltfDocument& document, const Palette& palette) const;

 private:
  struct Ring {
    std::size_t element;
    int place;       // on the element's curve
    bool continued;  // by the next ring
  };

  const Structure& structure_;
  ElementCurve curve_;
  std::vector<Ring> rings_;
  std::vector<GltfTrack> joints_;  // by rings_
};

}  // namespace netpocket
