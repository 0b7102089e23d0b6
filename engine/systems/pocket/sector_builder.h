#pragma once
// Adds nodes, gradients and elements to a model for all sectors of a pocket at once, numbered sector fastest.

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "engine/model/model.h"
#include "engine/state/pocket_groups.h"

namespace netpocket {

// A node or gradient of every sector. `local` is its index within the sector; `next` refers to the following sector.
struct SectorIndex {
  std::int32_t local = -1;
  bool next = false;

  SectorIndex of_next() const { return {local, true}; }
  bool operator==(const SectorIndex&) const = default;
};

// A chain of elements from knot to knot; every sector has one.
struct SectorThread {
  std::vector<SectorIndex> nodes;
  std::vector<SectorIndex> gradients;  // one per node
  std::vector<std::int32_t> elements;  // local indices: index in the model = local * sectors + sector
};

// Deviation of cords from the straight lines between their knots. The middle of each stretch is displaced by `rise`
// times its length, perpendicular to it and away from a point on the axis. The slope at the knots is unchanged.
struct Bow {
  double rise = 0;
  Eigen::Vector3d away_from = Eigen::Vector3d::Zero();  // m
};

class SectorBuilder {
 public:
  // `pair`: pairs of elements of a side share their axial strain (ancf/strain_pair.h), if they are equally long and the
  // material carries full compression. Adds to `model`, which must have no nodes, gradients or elements yet and must
  // outlive this.
  SectorBuilder(Model& model, int sectors, bool pair) : model_(model), sectors_(sectors), pair_(pair) {}

  int sectors() const { return sectors_; }
  // Horizontal unit vector from the axis towards rod `rod`; exactly symmetric under quarter turns.
  Eigen::Vector3d radial(int rod) const;

  // Adds a node to each sector, at position(sector) in m.
  SectorIndex add_node(const std::function<Eigen::Vector3d(int sector)>& position);
  Eigen::Vector3d position(SectorIndex node, int sector) const;
  std::int32_t node(SectorIndex index, int sector) const { return resolve(index, sector); }
  std::int32_t gradient(SectorIndex index, int sector) const { return resolve(index, sector); }
  std::int32_t element(std::int32_t local, int sector) const { return local * sectors_ + sector; }

  // Adds a thread along the straight line through `knots`, bent by `bow`, without axial strain. It has `divisions[i]`
  // elements between knots i and i+1 and one unit gradient per node. `name(sector)` names it.
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
