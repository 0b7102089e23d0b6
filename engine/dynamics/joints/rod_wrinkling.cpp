#include "engine/dynamics/joints/rod_wrinkling.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace netpocket {

RodWrinkling::RodWrinkling(const Model& model, std::span<const BatchElement> elements, bool full) : full_(full) {
  for (std::size_t m = 0; m < model.materials.size(); ++m) {
    if (model.materials[m].is_tube) moments_.emplace_back(m, model.materials[m].wrinkling_moment);
  }
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const std::int32_t material = model.elements[i].material;
    if (!model.materials[material].is_tube) continue;
    const auto [r1, g1, r2, g2] = elements[i].coordinate;
    rods_.push_back({{r1, g1, r2, g2},
                     material,
                     elements[i].length,
                     {elements[i].section.EI, model.materials[material].wrinkling_moment}});
  }
  find_whether_any_can_wrinkle();
}

void RodWrinkling::find_whether_any_can_wrinkle() {
  can_wrinkle_ = std::ranges::any_of(rods_, [](const Rod& rod) { return std::isfinite(rod.section.moment); });
}

double RodWrinkling::moment(std::int32_t material) const {
  const auto found = std::ranges::find(moments_, material, &std::pair<std::int32_t, double>::first);
  return found == moments_.end() ? std::numeric_limits<double>::infinity() : found->second;
}

void RodWrinkling::set_moment(std::int32_t material, double moment) {
  for (auto& [tube, present] : moments_) {
    if (tube == material) present = moment;
  }
  for (Rod& rod : rods_) {
    if (rod.material == material) rod.section.moment = moment;
  }
  find_whether_any_can_wrinkle();
}

void RodWrinkling::visit_state(const std::function<void(double&)>& visit) {
  constexpr double kInfinite = -1;  // saved states hold finite numbers only
  for (const auto& [material, moment] : moments_) {
    double number = std::isfinite(moment) ? moment : kInfinite;
    visit(number);
    const double visited = number < 0 ? std::numeric_limits<double>::infinity() : number;
    if (visited != moment) set_moment(material, visited);
  }
}

std::optional<Softening> RodWrinkling::softening(const Rod& rod, const CoordinateVectors& coordinates) const {
  ElementCoordinates q;
  for (int corner = 0; corner < 4; ++corner) q.col(corner) = coordinates.get(rod.coordinate[corner]);
  return full_ ? full_softening(rod.section, rod.length, q) : mean_strain_softening(rod.section, rod.length, q);
}

void RodWrinkling::add_forces(const CoordinateVectors& coordinates, AppliedForces& applied) const {
  if (!can_wrinkle_) return;
  for (const Rod& rod : rods_) {
    const std::optional<Softening> softer = softening(rod, coordinates);
    if (!softer) continue;
    for (int corner = 0; corner < 4; ++corner) applied.add(rod.coordinate[corner], softer->force.col(corner));
  }
}

double RodWrinkling::energy(const CoordinateVectors& coordinates) const {
  double energy = 0;
  if (!can_wrinkle_) return energy;
  for (const Rod& rod : rods_) {
    if (const std::optional<Softening> softer = softening(rod, coordinates)) energy += softer->energy;
  }
  return energy;
}

}  // namespace netpocket
