#include "engine/dynamics/assembly/tied_coordinates.h"

#include <algorithm>

namespace netpocket {

TiedCoordinates::TiedCoordinates(const SectorModel& sector, const CoordinateLayout& layout) : sectors_(sector.sectors) {
  const SectorTurn turn(sector.sectors);
  const auto add = [&](std::int32_t coordinate, int turns) {
    places_.push_back({coordinate, turns != 0, 0, 0, turn.cosine(turns), turn.sine(turns)});
    coordinates_.push_back(coordinate);
    blocks_.push_back(coordinate / kBlockSize);
  };
  const auto add_ties = [&](const std::vector<SectorModel::Tie>& ties, std::int32_t first) {
    for (std::size_t i = 0; i < ties.size(); ++i) {
      const SectorModel::Tie& tie = ties[i];
      if (i == 0 || ties[i - 1].leader != tie.leader) {
        groups_.push_back({places_.size(), 1});
        add(first + tie.leader, 0);
      }
      ++groups_.back().count;
      add(first + tie.follower, tie.turns);
    }
  };
  add_ties(sector.ties, layout.position(0));
  add_ties(sector.gradient_ties, layout.gradient(0));
  std::ranges::sort(blocks_);
  blocks_.erase(std::unique(blocks_.begin(), blocks_.end()), blocks_.end());
  rows_.resize(blocks_.size() * kRows);
  before_.resize(places_.size());
  own_.resize(places_.size());
  others_ = groups_;
  const auto row_of = [](std::int32_t coordinate, std::ptrdiff_t block) {
    return static_cast<std::size_t>(block) * kRows + static_cast<std::size_t>(coordinate % kBlockSize);
  };
  for (Place& place : places_) {
    const auto block = std::ranges::lower_bound(blocks_, place.coordinate / kBlockSize) - blocks_.begin();
    place.block = static_cast<std::int32_t>(block);
    place.row = row_of(place.coordinate, block);
  }
  for (const Group& group : groups_) {
    const std::int32_t leader = coordinates_[group.first];
    for (std::size_t i = group.first + 1; i < group.first + group.count; ++i) {
      const Place& place = places_[i];
      followers_.push_back({row_of(place.coordinate, place.coordinate / kBlockSize),
                            row_of(leader, leader / kBlockSize), place.row, place.is_turned, place.cosine, place.sine});
    }
  }
}

std::vector<TiedCoordinates::Group> TiedCoordinates::groups_with(std::span<const std::int32_t> coordinates) const {
  std::vector<Group> found;
  for (const Group& group : groups_) {
    const auto is_one = [&](std::int32_t copy) { return std::ranges::binary_search(coordinates, copy); };
    if (std::ranges::any_of(copies(group), is_one)) found.push_back(group);
  }
  return found;
}

void TiedCoordinates::share_masses(std::span<const Group> groups, std::span<const double> mass,
                                   std::span<double> inverse_mass, std::span<double> moving_mass) const {
  for (const Group& group : groups) {
    double total = 0;
    for (const std::int32_t copy : copies(group)) total += mass[static_cast<std::size_t>(copy)];
    for (const std::int32_t copy : copies(group)) {
      inverse_mass[static_cast<std::size_t>(copy)] = 1 / total;
      moving_mass[static_cast<std::size_t>(copy)] = 0;
    }
    moving_mass[static_cast<std::size_t>(coordinates_[group.first])] = total;
  }
}

void TiedCoordinates::lead_others(AppliedForces& applied) const {
  for (const Group& group : others_) {
    double x = 0, y = 0, z = 0;
    for (std::size_t i = group.first + 1; i < group.first + group.count; ++i) {
      const Place& place = places_[i];
      const double* force = rows_.data() + place.row;
      x += place.is_turned ? place.cosine * force[0] + place.sine * force[2 * kBlockSize] : force[0];
      y += force[kBlockSize];
      z += place.is_turned ? place.cosine * force[2 * kBlockSize] - place.sine * force[0] : force[2 * kBlockSize];
    }
    applied.add(places_[group.first].coordinate, {x, y, z});
  }
}

// Rows of blocks stand one after the other, as some_blocks_.
void TiedCoordinates::take_own() {
  for (const Group& group : chosen_) {
    for (std::size_t i = group.first; i < group.first + group.count; ++i) {
      const auto at = std::ranges::lower_bound(some_blocks_, places_[i].block) - some_blocks_.begin();
      const double* x = rows_.data() + static_cast<std::size_t>(at) * kRows +
                        static_cast<std::size_t>(places_[i].coordinate % kBlockSize);
      own_[i] = {x[0], x[kBlockSize], x[2 * kBlockSize]};
    }
  }
}

void TiedCoordinates::share_own(AppliedForces& applied) const {
  for (const Group& group : chosen_) {
    const std::size_t last = group.first + group.count;
    Eigen::Vector3d total = own_[group.first];
    for (std::size_t i = group.first + 1; i < last; ++i) total += turned_back(places_[i], own_[i]);
    for (std::size_t i = group.first; i < last; ++i) {
      applied.add(places_[i].coordinate, turned(places_[i], total) - own_[i]);
    }
  }
}

void TiedCoordinates::begin_applied(const AppliedForces& applied) {
  for (const Group& group : chosen_) {
    for (std::size_t i = group.first; i < group.first + group.count; ++i) {
      before_[i] = applied.get(places_[i].coordinate);
    }
  }
}

void TiedCoordinates::share_applied(AppliedForces& applied) {
  for (const Group& group : chosen_) {
    for (std::size_t i = group.first; i < group.first + group.count; ++i) {
      own_[i] = applied.get(places_[i].coordinate) - before_[i];
    }
  }
  share_own(applied);
}

void TiedCoordinates::follow(CoordinateVectors& positions, CoordinateVectors& velocities) const {
  const auto move = [](const Follower& follower, double* rows) {
    const double* leader = rows + follower.leader;
    double* place = rows + follower.place;
    const double x = leader[0], z = leader[2 * kBlockSize];
    place[kBlockSize] = leader[kBlockSize];
    place[0] = follower.is_turned ? follower.cosine * x - follower.sine * z : x;
    place[2 * kBlockSize] = follower.is_turned ? follower.sine * x + follower.cosine * z : z;
  };
  for (const Follower& follower : followers_) {
    move(follower, positions.data());
    move(follower, velocities.data());
  }
}

}  // namespace netpocket
