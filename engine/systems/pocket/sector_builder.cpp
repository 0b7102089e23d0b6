#include "engine/systems/pocket/sector_builder.h"

#include <cmath>
#include <numbers>

#include "engine/math/elementary.h"
#include "engine/math/symmetric_algebra.h"

namespace netpocket {

// Rods 0, n/4, n/2 and 3n/4 lie exactly on the axes. All others are rods of the first quarter with components swapped
// and negated.
Eigen::Vector3d SectorBuilder::radial(int rod) const {
  const auto first_quarter = [&](double angle) -> Eigen::Vector3d {
    if (angle == 0) return {1, 0, 0};
    if (4 * angle == std::numbers::pi) return {std::sqrt(0.5), 0, std::sqrt(0.5)};
    return {cosine(angle), 0, sine(angle)};
  };
  if (sectors_ % 4 != 0) {
    const double angle = 2 * std::numbers::pi * rod / sectors_;
    return {cosine(angle), 0, sine(angle)};
  }
  const int per_quarter = sectors_ / 4;
  Eigen::Vector3d direction = first_quarter(2 * std::numbers::pi * (rod % per_quarter) / sectors_);
  for (int turn = 0; turn < rod / per_quarter % 4; ++turn)
    direction = Eigen::Vector3d(-direction.z(), 0, direction.x());
  return direction;
}

SectorIndex SectorBuilder::add_node(const std::function<Eigen::Vector3d(int)>& position) {
  for (int sector = 0; sector < sectors_; ++sector) model_.add_node(position(sector));
  return {node_locals_++};
}

Eigen::Vector3d SectorBuilder::position(SectorIndex node, int sector) const {
  return model_.nodes[resolve(node, sector)].position;
}

// Point at the fraction `part` of a stretch. The bow is the quartic with no slope at the ends.
Eigen::Vector3d SectorBuilder::bowed(const SectorIndex& from, const SectorIndex& to, double part, int sector,
                                     const Bow& bow) const {
  const Eigen::Vector3d start = position(from, sector), end = position(to, sector);
  const Eigen::Vector3d straight = (1 - part) * start + part * end;
  if (bow.rise == 0) return straight;
  const Eigen::Vector3d span = end - start;
  const double length = symmetric_norm(span);
  const Eigen::Vector3d tangent = span / length;
  const Eigen::Vector3d away = 0.5 * (start + end) - bow.away_from;
  const Eigen::Vector3d across = away - symmetric_dot(away, tangent) * tangent;
  const double size = symmetric_norm(across);
  if (size < 1e-9 * length) return straight;
  const double shape = 16 * part * part * (1 - part) * (1 - part);
  return straight + (bow.rise * length * shape / size) * across;
}

namespace {

// Length of an unstrained element: one between the ends of `chord`, with unit gradients along `direction` and no mean
// axial strain (mean_strain_element.h).
double unstrained_length(const Eigen::Vector3d& chord, const Eigen::Vector3d& direction) {
  double length = symmetric_norm(chord);
  for (int i = 0; i < 8; ++i) {  // each multiplies the error by the square of the small angle between the two
    const Eigen::Vector3d e = chord / length;
    length *= 1 + 0.5 * (symmetric_squared_norm(e) - 1 + 0.2 * symmetric_squared_norm(direction - e));
  }
  return length;
}

}  // namespace

// Pairs successive elements of each side if they are equally long. Elements on either side of a bow's flank are not.
// The last of an odd number stays single.
void SectorBuilder::pair_within_sides(const SectorThread& thread, const std::vector<int>& divisions) {
  std::size_t begin = 0;
  for (const int division : divisions) {
    for (int k = 0; k + 1 < division; k += 2) {
      const std::size_t place = begin + static_cast<std::size_t>(k);
      for (int sector = 0; sector < sectors_; ++sector) {
        const std::int32_t first = element(thread.elements[place], sector);
        const std::int32_t second = element(thread.elements[place + 1], sector);
        const double length = model_.elements[first].length;
        if (std::abs(model_.elements[second].length - length) < 1e-9 * length) model_.pair(first, second);
      }
    }
    begin += static_cast<std::size_t>(division);
  }
}

SectorThread SectorBuilder::add_thread(const std::vector<SectorIndex>& knots, const std::vector<int>& divisions,
                                       std::int32_t material, PocketGroup group,
                                       const std::function<std::string(int)>& name, const Bow& bow) {
  SectorThread thread;
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    thread.nodes.push_back(knots[i]);
    for (int k = 1; k < divisions[i]; ++k) {
      const double part = static_cast<double>(k) / divisions[i];
      thread.nodes.push_back(add_node([&](int sector) { return bowed(knots[i], knots[i + 1], part, sector, bow); }));
    }
  }
  thread.nodes.push_back(knots.back());

  const auto direction = [&](int sector) -> Eigen::Vector3d {
    const Eigen::Vector3d span = position(thread.nodes.back(), sector) - position(thread.nodes.front(), sector);
    return span / symmetric_norm(span);
  };
  for (const SectorIndex node : thread.nodes) {
    for (int sector = 0; sector < sectors_; ++sector) model_.add_gradient(resolve(node, sector), direction(sector));
    thread.gradients.push_back({gradient_locals_++});
  }

  std::vector<std::int32_t> thread_names;
  for (int sector = 0; sector < sectors_; ++sector) thread_names.push_back(model_.add_thread(name(sector)));
  for (std::size_t i = 0; i + 1 < thread.nodes.size(); ++i) {
    for (int sector = 0; sector < sectors_; ++sector) {
      const Eigen::Vector3d chord = position(thread.nodes[i + 1], sector) - position(thread.nodes[i], sector);
      const double length = bow.rise == 0 ? symmetric_norm(chord) : unstrained_length(chord, direction(sector));
      model_.add_element({resolve(thread.nodes[i], sector), resolve(thread.gradients[i], sector),
                          resolve(thread.nodes[i + 1], sector), resolve(thread.gradients[i + 1], sector), length,
                          material, index_of(group), thread_names[sector]});
    }
    thread.elements.push_back(element_locals_++);
  }
  if (pair_ && model_.materials[material].section.compression == 1) pair_within_sides(thread, divisions);
  return thread;
}

}  // namespace netpocket
