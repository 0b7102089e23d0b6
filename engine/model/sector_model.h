#pragma once
// One sector of a model that is the same after a turn about the y axis by a part of a full turn.
//
// Numbering. The index of the sector runs fastest in the whole model (model.h, "Speed"): an item of sector s has the
// index local * sectors + s, and one turn takes it to the item of sector s + 1.
//
// Lanes. Kernels compute eight elements at once where these read eight coordinates each that stand side by side. One
// sector has no eight equal parts. Its cords are therefore laid side by side, eight at a time, each with its own copy
// of the knots on it; a lane holds one cord after the other. Copies of a knot are tied: they move as one node. Between
// two cords of a lane and behind the last one stand idle elements without stiffness, mass and contact. A few cords
// whose elements have no strain partners (rods) are cut to fill the lanes; at a cut the gradient has a copy too.
//
// Turned nodes. A cord may end at a node of another sector. That is a copy of the sector's own node, tied to it by a
// turn.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/model/model.h"

namespace netpocket {

// Turns about the y axis by the angle from one sector to the next, exact under quarter turns.
class SectorTurn {
 public:
  explicit SectorTurn(int sectors);

  // `turns`: more than -sectors, less than sectors.
  int sectors() const { return static_cast<int>(cosine_.size()); }
  double cosine(int turns) const { return cosine_[index(turns)]; }
  double sine(int turns) const { return sine_[index(turns)]; }
  Eigen::Vector3d operator()(int turns, const Eigen::Vector3d& v) const {
    const double c = cosine(turns), s = sine(turns);
    return {c * v.x() - s * v.z(), v.y(), s * v.x() + c * v.z()};
  }

 private:
  std::size_t index(int turns) const { return static_cast<std::size_t>(turns < 0 ? turns + sectors() : turns); }
  std::vector<double> cosine_, sine_;
};

// Why the model is not the same after a turn, one clause; nothing when it is. Numbers that agree to 1e-9 (m, kg, N, or
// of their size) are the same. Refuses models with lines, ropes through rings, locks or an orbit. Does not look at the
// shapes of bodies.
std::optional<std::string> find_asymmetry(const Model& whole, int sectors);

struct SectorModel {
  struct Tie {
    std::int32_t leader, follower;  // nodes of `model`, or gradients
    int turns;                      // that take the leader to the follower
  };

  Model model;
  int sectors = 1;
  std::vector<std::int32_t> node_of, gradient_of, element_of;  // by index in `model`: that in the whole; -1: idle
  std::vector<Tie> ties, gradient_ties;                        // of nodes and of gradients, sorted by leader
  std::int32_t idle_material = -1;
};

// The first sector of a model without asymmetry. Its ropes and hinges are those of the whole with the indices 0,
// sectors, 2 sectors, ...; bodies and materials have the same indices, but what acts on bodies is that of one sector.
SectorModel sector_model(const Model& whole, int sectors);

}  // namespace netpocket
