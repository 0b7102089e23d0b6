#pragma once
// Copies of one node, in one sector of a system that steps for all (model/sector_model.h). A copy, the follower, moves
// as its leader, turned about the y axis by a number of sectors. They share their mass, and a force on a follower acts
// on the leader, turned back.
//
// For sums of forces every copy gets the force on all of them, so that each moves rightly by itself.

#include <span>
#include <vector>

#include "engine/base/aligned_vector.h"
#include "engine/dynamics/assembly/applied_forces.h"
#include "engine/dynamics/assembly/coordinate_vectors.h"
#include "engine/model/sector_model.h"

namespace netpocket {

class TiedCoordinates {
 public:
  TiedCoordinates(const SectorModel& sector, const CoordinateLayout& layout);

  int sectors() const { return sectors_; }

  // From the mass of each coordinate by itself: the inverse of the common mass for all copies, and the common mass as
  // the moving mass of leaders. `changed`: coordinates whose mass may have changed; empty: all.
  void share_masses(std::span<const double> mass, std::span<double> inverse_mass, std::span<double> moving_mass,
                    std::span<const std::int32_t> changed = {}) const;

  // Adds to `applied` what the other copies bear. `sum_forces`(blocks, rows): all forces on blocks of coordinates so
  // far.
  template <typename SumForces>
  void share_forces(const SumForces& sum_forces, AppliedForces& applied) {
    rows_.resize(blocks_.size() * kRows);
    sum_forces(std::span<const std::int32_t>(blocks_), rows_.data());
    share(applied, [this](const Place& place) { return row(place); });
  }
  // The same for forces that are added to `applied` between these two calls.
  void begin_applied(const AppliedForces& applied);
  void share_applied(AppliedForces& applied);

  // Moves followers as their leaders.
  void follow(CoordinateVectors& vectors) const;

  // Calls function(first, count) with the coordinates of each node that has copies; the leader is the first.
  template <typename Function>
  void for_each_group(const Function& function) const {
    for (const Group& group : groups_) {
      function(std::span<const std::int32_t>(coordinates_).subspan(group.first, group.count));
    }
  }

 private:
  static constexpr std::size_t kRows = kVectorRows * kBlockSize;

  struct Place {
    std::int32_t coordinate;
    std::size_t row;      // of its x in rows_
    double cosine, sine;  // of the turn from the leader
  };
  struct Group {
    std::size_t first, count;  // of places_
  };

  static Eigen::Vector3d turned(const Place& place, const Eigen::Vector3d& v) {
    return {place.cosine * v.x() - place.sine * v.z(), v.y(), place.sine * v.x() + place.cosine * v.z()};
  }
  static Eigen::Vector3d turned_back(const Place& place, const Eigen::Vector3d& v) {
    return {place.cosine * v.x() + place.sine * v.z(), v.y(), place.cosine * v.z() - place.sine * v.x()};
  }
  Eigen::Vector3d row(const Place& place) const {
    const double* x = rows_.data() + place.row;
    return {x[0], x[kBlockSize], x[2 * kBlockSize]};
  }
  // `force`(place): the force on a copy that the others shall bear too.
  template <typename Force>
  void share(AppliedForces& applied, const Force& force) const;

  int sectors_;
  std::vector<Place> places_;              // leaders before their followers
  std::vector<std::int32_t> coordinates_;  // of places_
  std::vector<Group> groups_;
  std::vector<std::int32_t> blocks_;  // that hold places, ascending
  AlignedVector<double> rows_;        // forces on them
  std::vector<Eigen::Vector3d> before_;
};

template <typename Force>
void TiedCoordinates::share(AppliedForces& applied, const Force& force) const {
  for (const Group& group : groups_) {
    const std::span<const Place> places(places_.data() + group.first, group.count);
    Eigen::Vector3d total = force(places[0]);
    for (const Place& place : places.subspan(1)) total += turned_back(place, force(place));
    for (const Place& place : places) applied.add(place.coordinate, turned(place, total) - force(place));
  }
}

}  // namespace netpocket
