#pragma once
// Adds nodes, gradients and elements to a model for all sectors of a pocket at once, numbered sector fastest.

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "engine/model/model.h"
#include "engine/state/pocket_groups.h"

namespace netpocket {

// A node or gradient of every sector: `local` counts within a sector; `next` refers to the following sector's.
struct SectorIndex {
  std::int32_t local = -1;
  bool next = false;

  SectorIndex of_next() const { return {local, true}; }
  bool operator==(const SectorIndex&) const = default;
};

// A chain of elements through every sector, from knot to knot.
struct SectorThread {
  std::vector<SectorIndex> nodes;
  std::vector<SectorIndex> gradients;  // one for each node
  std::vector<std::int32_t> elements;  // local: index in the model = local * sectors + sector
};

// How cords deviate from straight lines between their knots: every stretch rises by `rise` times its length at its
// middle, across itself and away from a point on the axis, with no slope at the knots.
struct Bow {
  double rise = 0;
  Eigen::Vector3d away_from = Eigen::Vector3d::Zero();  // m
};

class SectorBuilder {
 public:
  // `pair`: elements of a side share their axial strain two by two (ancf/strain_pair.h), where they are equally long
  // and the material carries full compression. Adds to `model`, which must not have nodes, gradients or elements yet.
  SectorBuilder(Model& model, int sectors, bool pair) : model_(model), sectors_(sectors), pair_(pair) {}

  int sectors() const { return sectors_; }
  // Horizontal unit vector from the axis towards rod `rod`; exact under quarter turns.
  Eigen::Vector3d radial(int rod) const;

  // A node of each sector at position(sector).
  SectorIndex add_node(const std::function<Eigen::Vector3d(int sector)>& position);
  Eigen::Vector3d position(SectorIndex node, int sector) const;
  std::int32_t node(SectorIndex index, int sector) const { return resolve(index, sector); }
  std::int32_t gradient(SectorIndex index, int sector) const { return resolve(index, sector); }
  std::int32_t element(std::int32_t local, int sector) const { return local * sectors_ + sector; }

  // A thread along the straight line through `knots`, `divisions[i]` elements between knot i and i+1, free of axial
  // strain; one gradient per node, of unit length. `name(sector)` names it.
  SectorThread add_thread(const std::vector<SectorIndex>& knots, const std::vector<int>& divisions,
                          std::int32_t material, PocketGroup group, const std::function<std::string(int sector)>& name,
                          const Bow& bow = {});

 private:
  Eigen::Vector3d bowed(const SectorIndex& from, const SectorIndex& to, double part, int sector, const Bow& bow) const;

  std::int32_t resolve(SectorIndex index, int sector) const {
    return index.local * sectors_ + (index.next ? (sector + 1) % sectors_ : sector);
  }

  void pair_within_sides(const SectorThread& thread, const std::vector<int>& divisions);

  Model& model_;
  int sectors_;
  bool pair_;
  std::int32_t node_locals_ = 0, gradient_locals_ = 0, element_locals_ = 0;
};

}  // namespace netpocket
