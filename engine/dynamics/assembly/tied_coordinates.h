#pragma once
// Copies of one node, in one sector of a system that steps for all (model/sector_model.h). A copy, the follower, moves
// as its leader, turned about the y axis by a number of sectors. They share their mass, and a force on a follower acts
// on the leader, turned back.

#include <algorithm>
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

  // A node that has copies, and its copies: of places.
  struct Group {
    std::size_t first, count;
  };
  const std::vector<Group>& groups() const { return groups_; }
  // Those that hold any of these coordinates, which are sorted.
  std::vector<Group> groups_with(std::span<const std::int32_t> coordinates) const;
  // Coordinates of a group; the leader is the first.
  std::span<const std::int32_t> copies(const Group& group) const {
    return {coordinates_.data() + group.first, group.count};
  }

  // From the mass of each coordinate by itself: the inverse of the common mass for all copies, and the common mass as
  // the moving mass of leaders.
  void share_masses(std::span<const Group> groups, std::span<const double> mass, std::span<double> inverse_mass,
                    std::span<double> moving_mass) const;

  // Begins a step. The copies of chosen groups shall move rightly by themselves, because something depends on how they
  // will. Of all others only the leader. `is_chosen`(coordinates of a group).
  template <typename IsChosen>
  void choose(const IsChosen& is_chosen) {
    chosen_.clear();
    others_.clear();
    for (const Group& group : groups_) (is_chosen(copies(group)) ? chosen_ : others_).push_back(group);
  }
  void choose_none() {
    if (chosen_.empty()) return;
    chosen_.clear();
    others_ = groups_;
  }
  // Adds to the applied forces of the chosen copies what the others of their group bear. `sum_forces`(blocks, rows):
  // all forces so far on blocks of coordinates.
  template <typename SumForces>
  void share(const SumForces& sum_forces, AppliedForces& applied) {
    if (chosen_.empty()) return;
    collect(chosen_, sum_forces);
    share_own(applied);
  }
  // The same for forces that are added to `applied` between these two calls.
  void begin_applied(const AppliedForces& applied);
  void share_applied(AppliedForces& applied);
  // Adds to the applied forces of all other leaders what their followers bear.
  template <typename SumForces>
  void lead(const SumForces& sum_forces, AppliedForces& applied) {
    sum_forces(std::span<const std::int32_t>(blocks_), rows_.data());
    lead_others(applied);
  }

  // Moves followers as their leaders.
  void follow(CoordinateVectors& positions, CoordinateVectors& velocities) const;
  void follow(CoordinateVectors& vectors) const { follow(vectors, vectors); }

 private:
  static constexpr std::size_t kRows = kVectorRows * kBlockSize;

  struct Place {
    std::int32_t coordinate;
    bool is_turned;       // from the leader
    std::int32_t block;   // index into blocks_
    std::size_t row;      // of its x in rows_
    double cosine, sine;  // of the turn
  };
  // Of its x among the rows of all coordinates, and of its leader.
  struct Follower {
    std::size_t place, leader, row;
    bool is_turned;
    double cosine, sine;
  };

  static Eigen::Vector3d turned(const Place& place, const Eigen::Vector3d& v) {
    return {place.cosine * v.x() - place.sine * v.z(), v.y(), place.sine * v.x() + place.cosine * v.z()};
  }
  static Eigen::Vector3d turned_back(const Place& place, const Eigen::Vector3d& v) {
    return {place.cosine * v.x() + place.sine * v.z(), v.y(), place.cosine * v.z() - place.sine * v.x()};
  }
  // Stores the forces on the copies of these groups in own_.
  template <typename SumForces>
  void collect(std::span<const Group> groups, const SumForces& sum_forces) {
    some_blocks_.clear();
    for (const Group& group : groups) {
      for (std::size_t i = group.first; i < group.first + group.count; ++i) some_blocks_.push_back(places_[i].block);
    }
    std::ranges::sort(some_blocks_);
    some_blocks_.erase(std::unique(some_blocks_.begin(), some_blocks_.end()), some_blocks_.end());
    wanted_.clear();
    for (const std::int32_t block : some_blocks_) wanted_.push_back(blocks_[static_cast<std::size_t>(block)]);
    sum_forces(std::span<const std::int32_t>(wanted_), rows_.data());
    take_own();
  }
  void take_own();
  // Adds to the applied force of each chosen copy what the others have in own_.
  void share_own(AppliedForces& applied) const;
  void lead_others(AppliedForces& applied) const;

  int sectors_;
  std::vector<Place> places_;              // leaders before their followers
  std::vector<std::int32_t> coordinates_;  // of places_
  std::vector<Group> groups_;
  std::vector<Follower> followers_;
  std::vector<Group> chosen_, others_;
  std::vector<std::int32_t> blocks_;       // of coordinates that hold copies, ascending
  std::vector<std::int32_t> some_blocks_;  // indices into blocks_
  std::vector<std::int32_t> wanted_;
  AlignedVector<double> rows_;                 // forces on blocks
  std::vector<Eigen::Vector3d> before_, own_;  // by place
};

}  // namespace netpocket
