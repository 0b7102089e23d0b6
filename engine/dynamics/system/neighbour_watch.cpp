#include "engine/dynamics/system/neighbour_watch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include "engine/math/elementary.h"

namespace netpocket {
namespace {

// Gap (m) of cords that must be left: more than what they approach each other by in a step.
constexpr double kReach = 0.1;

// Index of what stands for each place in the sectors: the first copy of it.
std::map<std::int32_t, std::int32_t> first_copies(const std::vector<std::int32_t>& of_whole, int sectors) {
  std::map<std::int32_t, std::int32_t> copies;
  for (std::size_t i = 0; i < of_whole.size(); ++i) {
    if (of_whole[i] >= 0) copies.try_emplace(of_whole[i] / sectors, static_cast<std::int32_t>(i));
  }
  return copies;
}

// A cord's cubic lies within the hull of its Bezier points, here seen along the y axis.
std::array<Eigen::Vector2d, 4> hull_of(const CableState& state, const ModelElement& element, double length) {
  const auto seen = [](const Eigen::Vector3d& v) { return Eigen::Vector2d(v.x(), v.z()); };
  const CoordinateLayout& layout = state.layout;
  const Eigen::Vector2d start = seen(state.coordinates.get(layout.position(element.node1))),
                        end = seen(state.coordinates.get(layout.position(element.node2)));
  const double third = length / 3;
  return {start, start + third * seen(state.coordinates.get(layout.gradient(element.gradient1))),
          end - third * seen(state.coordinates.get(layout.gradient(element.gradient2))), end};
}

// m, of the nearest point of a straight line between two points from the axis.
double distance_from_axis(const Eigen::Vector2d& start, const Eigen::Vector2d& end) {
  const Eigen::Vector2d along = end - start;
  const double squared = along.squaredNorm();
  const double part = squared > 0 ? std::clamp(-start.dot(along) / squared, 0.0, 1.0) : 0;
  return (start + part * along).norm();
}

}  // namespace

NeighbourWatch::NeighbourWatch(const Model& whole, const CableState& state, const CableElements& elements,
                               const SectorModel& sector)
    : sector_(sector), turn_(sector.sectors), contacted_(0) {
  const int sectors = sector.sectors;
  std::map<std::int32_t, std::int32_t> nodes, gradients;  // index here by index in the whole
  const auto take = [](std::map<std::int32_t, std::int32_t>& taken, std::int32_t index) {
    return taken.try_emplace(index, static_cast<std::int32_t>(taken.size())).first->second;
  };
  const auto element_copies = first_copies(sector.element_of, sectors);
  for (std::size_t i = 0; i < whole.elements.size(); ++i) {
    if (i % static_cast<std::size_t>(sectors) > 1) continue;
    ModelElement element = whole.elements[i];
    element.node1 = take(nodes, element.node1);
    element.node2 = take(nodes, element.node2);
    element.gradient1 = take(gradients, element.gradient1);
    element.gradient2 = take(gradients, element.gradient2);
    element.strain_partner = -1;
    model_.elements.push_back(element);
    element_of_sector_.push_back(element_copies.at(static_cast<std::int32_t>(i) / sectors));
  }
  model_.materials = whole.materials;
  model_.threads = whole.threads;
  model_.bodies = whole.bodies;
  model_.contact = whole.contact;
  model_.nodes.resize(nodes.size());
  model_.gradients.resize(gradients.size());
  layout_ = layout_of(model_);
  coordinates_ = velocities_ = CoordinateVectors(layout_.size());
  contacted_ = ContactedCoordinates(layout_.size());
  std::vector<double> inverse_mass(static_cast<std::size_t>(layout_.size()), 0.0);
  const auto add = [&](std::int32_t coordinate, std::int32_t of_whole, std::int32_t of_sector, int turns) {
    copies_.push_back({coordinate, of_sector, turns});
    coordinates_.set(coordinate, state.coordinates.get(of_whole));
    inverse_mass[static_cast<std::size_t>(coordinate)] = elements.inverse_mass()[static_cast<std::size_t>(of_whole)];
  };
  const CoordinateLayout of_sector = layout_of(sector.model);
  const auto node_copies = first_copies(sector.node_of, sectors);
  for (const auto& [index, here] : nodes) {
    const auto place = static_cast<std::size_t>(here);
    model_.nodes[place] = whole.nodes[static_cast<std::size_t>(index)];
    const std::int32_t copy = node_copies.at(index / sectors);
    add(layout_.position(here), state.layout.position(index), of_sector.position(copy),
        index % sectors - sector.node_of[static_cast<std::size_t>(copy)] % sectors);
  }
  const auto gradient_copies = first_copies(sector.gradient_of, sectors);
  for (const auto& [index, here] : gradients) {
    const auto place = static_cast<std::size_t>(here);
    model_.gradients[place] = whole.gradients[static_cast<std::size_t>(index)];
    model_.gradients[place].node = nodes.at(model_.gradients[place].node);
    const std::int32_t copy = gradient_copies.at(index / sectors);
    add(layout_.gradient(here), state.layout.gradient(index), of_sector.gradient(copy),
        index % sectors - sector.gradient_of[static_cast<std::size_t>(copy)] % sectors);
  }
  for (const ModelElement& element : model_.elements) lengths_.push_back(element.length);
  contact_ = std::make_unique<CordContact>(model_, layout_, coordinates_, inverse_mass);
}

void NeighbourWatch::forget() {
  contact_->forget_candidates();
  gap_ = way_ = 0;
}

void NeighbourWatch::take_over(const CableState& sector, const std::vector<double>& lengths) {
  for (const Copy& copy : copies_) {
    coordinates_.set(copy.coordinate, turn_(copy.turns, sector.coordinates.get(copy.of_sector)));
    velocities_.set(copy.coordinate, turn_(copy.turns, sector.velocities.get(copy.of_sector)));
  }
  for (std::size_t i = 0; i < lengths_.size(); ++i) {
    lengths_[i] = lengths[static_cast<std::size_t>(element_of_sector_[i])];
  }
}

// Seen along the axis, a sector takes up an angle at a distance from the axis. The one after the next is turned by two
// sectors; between points of both that are at least r from the axis and an angle a apart, the distance is at least
// 2 r sin(a/2). A lower bound, m.
double NeighbourWatch::gap_of_far_sectors(const CableState& sector, const std::vector<double>& lengths) const {
  const double half = std::numbers::pi / sector_.sectors;
  double first = 0, last = 0, nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < sector_.element_of.size(); ++i) {
    if (sector_.element_of[i] < 0) continue;
    const auto hull = hull_of(sector, sector_.model.elements[i], lengths[i]);
    for (std::size_t k = 0; k < hull.size(); ++k) {
      double angle = arc_tangent(hull[k].y(), hull[k].x()) - half;
      if (angle < -std::numbers::pi) angle += 2 * std::numbers::pi;
      first = std::min(first, angle);
      last = std::max(last, angle);
      for (std::size_t m = 0; m < k; ++m) nearest = std::min(nearest, distance_from_axis(hull[k], hull[m]));
    }
  }
  if (!(last - first < std::numbers::pi)) return 0;  // a hull may hold the axis
  const double apart = std::min(4 * half - (last - first), std::numbers::pi);
  return apart > 0 ? 2 * nearest * sine(0.5 * apart) : 0;
}

std::optional<std::string> NeighbourWatch::look(const CableState& sector, const std::vector<double>& lengths,
                                                const Motion& motion) {
  contact_->note_way(motion.way);
  way_ += motion.way;
  if (sector_.sectors > 3 && !(gap_ - 2 * way_ > kReach)) {
    gap_ = gap_of_far_sectors(sector, lengths);
    way_ = 0;
    if (!(gap_ > kReach)) return "cords of sectors that are not adjacent come near each other";
  }
  if (!contact_->may_find_any(motion.cord_speed, motion.dt)) return std::nullopt;
  take_over(sector, lengths);
  contact_->look_around(coordinates_, lengths_, motion.cord_speed, motion.dt, undivided_loop);
  contacted_.clear();
  contact_->find(coordinates_, velocities_, lengths_, motion.last_step, motion.dt, contacted_);
  if (contact_->has_found_any()) return "cords touch each other";
  return std::nullopt;
}

}  // namespace netpocket
