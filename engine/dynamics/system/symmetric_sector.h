#pragma once
// One sector of a system that stands for all sectors as long as the system is symmetric (THEORY.md, "Symmetric
// captures"). It is a system of its own, in which nodes at the border of the next sector are turned images of the own
// ones, and what acts on a body acts from all sectors.
//
// Symmetry is checked and not assumed: of the model when this is built, of the state whenever a sector begins to stand
// for the whole. From then on it follows from what acts on the system. Before each step it is asked whether anything
// does that is not symmetric, or that a sector cannot tell: then the whole system goes on from the same state.
// Internal to this room.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/dynamics/system/cable_system_impl.h"
#include "engine/dynamics/system/neighbour_watch.h"
#include "engine/model/sector_model.h"

namespace netpocket {

class SymmetricSector {
 public:
  using System = CableSystem::Impl;

  // `whole` must outlive this object. Begins to stand for it if it is symmetric.
  SymmetricSector(System& whole, int sectors);

  bool is_active() const { return active_; }
  const SymmetryStatus& status() const { return status_; }
  // The system of one sector. Bodies and materials have the indices of the whole.
  System& part() { return *part_; }
  std::int32_t rope_of(std::int32_t rope) const { return rope / sector_.sectors; }
  std::int32_t element_of(std::int32_t element) const;  // index in the whole, of the first sector

  // Gives the whole system the present state, if it does not have it.
  void unfold();
  // To be called when the sector has changed otherwise than by a step.
  void note_change() { unfolded_ = -1; }
  // Fills positions, elements, ropes and contacts of all sectors in.
  void unfold(const Snapshot& part, Snapshot& whole) const;
  Eigen::Vector3d position(std::int32_t node) const { return of_node(part_->state.coordinates, node); }
  Eigen::Vector3d velocity(std::int32_t node) const { return of_node(part_->state.velocities, node); }
  Eigen::Vector3d gradient(std::int32_t gradient) const;

  // Each may find that it breaks the symmetry. Then the whole system is active and takes it instead.
  void control(std::int32_t body, const BodyControl& control);
  void wind(std::int32_t rope, const RopeMotion& motion);
  void set_wrinkling_moment(std::int32_t material, double moment);
  void step(double dt, double spring_step);

  void leave(const std::string& reason);
  void visit_state(const std::function<void(double&)>& visit);

 private:
  // What stands for a node, gradient or element of each sector.
  struct Copy {
    std::int32_t place, local;
    int turns;  // of the sector that it is of
  };

  void list_copies();
  void try_to_enter();
  std::optional<std::string> asymmetry() const;  // of the state of the whole
  void fold();                                   // gives the sector the state of the whole
  std::optional<std::string> obstacle(double dt);
  bool take_winding();
  void exchange(System& from, System& to) const;
  template <typename Function>
  void for_each_image(const Copy& copy, const Function& function) const;
  void unfold(const CoordinateVectors& part, CoordinateVectors& whole) const;
  void fold(const CoordinateVectors& whole, CoordinateVectors& part) const;
  Eigen::Vector3d of_node(const CoordinateVectors& vectors, std::int32_t node) const;

  System& whole_;
  SectorModel sector_;
  SectorTurn turn_;
  std::unique_ptr<System> part_;  // null: the model is not symmetric
  std::optional<NeighbourWatch> watch_;
  std::vector<Copy> nodes_, gradients_, elements_;
  std::vector<std::int32_t> copy_of_node_, copy_of_gradient_;  // by local index
  std::vector<bool> is_round_;                                 // by body: whether its surface is one of revolution
  std::vector<std::optional<RopeMotion>> winding_;             // by rope of the whole: asked for in this step
  bool active_ = false;
  std::int64_t unfolded_ = -1;  // version of the sector's state that the whole has
  SymmetryStatus status_;
};

}  // namespace netpocket
