#include "engine/dynamics/assembly/tied_coordinates.h"

#include <algorithm>

namespace netpocket {

TiedCoordinates::TiedCoordinates(const SectorModel& sector, const CoordinateLayout& layout)
    : sectors_(sector.sectors) {
  const SectorTurn turn(sector.sectors);
  const auto add = [&](std::int32_t node, int turns) {
    const std::int32_t coordinate = layout.position(node);
    places_.push_back({coordinate, 0, turn.cosine(turns), turn.sine(turns)});
    coordinates_.push_back(coordinate);
    blocks_.push_back(coordinate / kBlockSize);
  };
  for (std::size_t i = 0; i < sector.ties.size(); ++i) {
    const SectorModel::Tie& tie = sector.ties[i];
    if (i == 0 || sector.ties[i - 1].leader != tie.leader) {
      groups_.push_back({places_.size(), 1});
      add(tie.leader, 0);
    }
    ++groups_.back().count;
    add(tie.follower, tie.turns);
  }
  std::ranges::sort(blocks_);
  blocks_.erase(std::unique(blocks_.begin(), blocks_.end()), blocks_.end());
  for (Place& place : places_) {
    const auto block = std::ranges::lower_bound(blocks_, place.coordinate / kBlockSize) - blocks_.begin();
    place.row = static_cast<std::size_t>(block) * kRows + static_cast<std::size_t>(place.coordinate % kBlockSize);
  }
}

void TiedCoordinates::share_masses(std::span<const double> mass, std::span<double> inverse_mass,
                                   std::span<double> moving_mass, std::span<const std::int32_t> changed) const {
  const auto has_changed = [&](std::int32_t coordinate) { return std::ranges::binary_search(changed, coordinate); };
  for_each_group([&](std::span<const std::int32_t> copies) {
    if (!changed.empty() && std::ranges::none_of(copies, has_changed)) return;
    double total = 0;
    for (const std::int32_t copy : copies) total += mass[static_cast<std::size_t>(copy)];
    for (const std::int32_t copy : copies) {
      inverse_mass[static_cast<std::size_t>(copy)] = 1 / total;
      moving_mass[static_cast<std::size_t>(copy)] = copy == copies.front() ? total : 0;
    }
  });
}

void TiedCoordinates::begin_applied(const AppliedForces& applied) {
  before_.clear();
  for (const Place& place : places_) before_.push_back(applied.get(place.coordinate));
}

void TiedCoordinates::share_applied(AppliedForces& applied) {
  std::vector<Eigen::Vector3d>& added = before_;
  for (std::size_t i = 0; i < places_.size(); ++i) added[i] = applied.get(places_[i].coordinate) - added[i];
  share(applied, [&](const Place& place) { return added[static_cast<std::size_t>(&place - places_.data())]; });
}

void TiedCoordinates::follow(CoordinateVectors& vectors) const {
  for (const Group& group : groups_) {
    const Eigen::Vector3d leader = vectors.get(places_[group.first].coordinate);
    for (std::size_t i = 1; i < group.count; ++i) {
      const Place& place = places_[group.first + i];
      vectors.set(place.coordinate, turned(place, leader));
    }
  }
}

}  // namespace netpocket
