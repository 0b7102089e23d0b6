#pragma once
// Which cable elements may touch which bodies, and which other elements.
// Bodies ask FCL's dynamic tree of the elements' bounding boxes (Pan, Chitta & Manocha 2012,
// doi:10.1109/ICRA.2012.6225337); pairs of elements come from sweeps. The lists hold everything nearer than `margin`,
// so they stay complete until something has moved by half of it; only then are they built again. They depend on the
// boxes alone, in ascending order, never on the tree's history.
//
//   if (broad_phase.advance(largest_speed * dt)) broad_phase.update(element_boxes, bodies);
//   for (int element : broad_phase.candidates(body)) ...
//
// World frame, m. Thread contract: one thread at a time.

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "engine/bodies/shape.h"
#include "engine/contact/divided_loop.h"

namespace netpocket {

struct PlacedShape {
  Shape shape;
  Eigen::Vector3d position;  // of its centre
  Eigen::Matrix3d rotation;  // body axes to world axes
};

class BroadPhase {
 public:
  static constexpr double kLeastInHand = 0.1;

  // Throws std::invalid_argument unless element_count >= 0 and margin > 0 (m).
  BroadPhase(int element_count, double margin);
  ~BroadPhase();
  BroadPhase(BroadPhase&&) noexcept;
  BroadPhase& operator=(BroadPhase&&) noexcept;

  // Notes that since the previous call no point of an element or of a body's surface has moved by more than `distance`.
  // True when the lists may no longer be complete and must be updated before they are used: at first, and each time the
  // distances add up to more than half the margin.
  bool advance(double distance);

  // Takes what has really moved since the lists were built, no point of an element by more than `distance` (m): keeps
  // the lists and says so if they can bear another kLeastInHand of the margin.
  bool keep(double distance, std::span<const PlacedShape> bodies);

  // Takes what has really moved since the lists were built, which is less than the sum of the distances when cords
  // vibrate: keeps the lists if they can bear another kLeastInHand of the margin, else rebuilds. True when it has
  // rebuilt. What moves from now on is to be noted by another advance. Arguments and errors are those of rebuild.
  bool update(std::span<const Eigen::AlignedBox3d> elements, std::span<const PlacedShape> bodies);

  // Builds the lists anew: one box per element that holds the whole cord, its radius included. Throws
  // std::invalid_argument when the number of boxes is not element_count.
  void rebuild(std::span<const Eigen::AlignedBox3d> elements, std::span<const PlacedShape> bodies);

  // Elements that may touch a body (index into rebuild's `bodies`), ascending: those whose box is within the margin of
  // the body's bounding box, less those whose box's circumscribed sphere is farther than the margin from the shape
  // itself.
  std::span<const int> candidates(int body) const { return candidates_[static_cast<std::size_t>(body)]; }

  // Pairs of elements whose boxes are within the margin of each other along every axis, smaller index first, ascending.
  // Neighbours in a net always are. Found anew by each call, whose threads may share the loops.
  std::vector<std::pair<int, int>> pairs(const DividedLoop& loop = undivided_loop) const;

  double margin() const { return margin_; }
  int rebuild_count() const { return rebuild_count_; }

 private:
  double displacement(std::span<const Eigen::AlignedBox3d> elements) const;

  struct Tree;
  std::unique_ptr<Tree> tree_;
  int element_count_;
  double margin_;
  double travelled_;  // m, bound on any motion since the last rebuild
  int rebuild_count_ = 0;
  std::vector<Eigen::AlignedBox3d> built_elements_;  // of the last rebuild
  std::vector<PlacedShape> built_bodies_;
  std::vector<std::vector<int>> candidates_;
};

}  // namespace netpocket
