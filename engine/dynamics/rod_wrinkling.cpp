#include "engine/dynamics/rod_wrinkling.h"

#include <algorithm>
#include <cmath>

#include "engine/ancf/vector.h"
#include "engine/ancf/wrinkling.h"

namespace netpocket {
namespace {

// Bending modes of an element.
struct Modes {
  Modes(const SlotVectors& q, const std::int32_t (&slot)[4], double length) {
    const Eigen::Vector3d e = (q.get(slot[2]) - q.get(slot[0])) / length, g1 = q.get(slot[1]), g2 = q.get(slot[3]);
    s = g1 - g2;
    a = (g1 + g2) - 2 * e;
    curvature = std::sqrt(squared_norm(s) + 3 * squared_norm(a)) / length;
  }
  Eigen::Vector3d s, a;
  double curvature;  // 1/m
};

}  // namespace

RodWrinkling::RodWrinkling(const Model& model, std::span<const BatchElement> elements) {
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const std::int32_t material = model.elements[i].material;
    if (model.elements[i].kind != ElementKind::rod) continue;
    const auto [r1, g1, r2, g2] = elements[i].slot;
    rods_.push_back({{r1, g1, r2, g2},
                     material,
                     elements[i].length,
                     elements[i].section.EI,
                     model.materials[material].wrinkling_moment});
  }
  find_whether_any_can_wrinkle();
}

void RodWrinkling::find_whether_any_can_wrinkle() {
  can_wrinkle_ = std::ranges::any_of(rods_, [](const Rod& rod) { return std::isfinite(rod.moment); });
}

void RodWrinkling::set_moment(std::int32_t material, double moment) {
  for (Rod& rod : rods_) {
    if (rod.material == material) rod.moment = moment;
  }
  find_whether_any_can_wrinkle();
}

void RodWrinkling::add_forces(const SlotVectors& coordinates, SlotVectors& applied,
                              std::vector<std::int32_t>& touched) const {
  if (!can_wrinkle_) return;
  for (const Rod& rod : rods_) {
    const Modes modes(coordinates, rod.slot, rod.length);
    const double k = modes.curvature * rod.EI / rod.moment;
    if (!(k > 1)) continue;
    const double lost = (1 - InflatedBending(k).moment / k) * rod.EI / rod.length;
    const Eigen::Vector3d moment_s = lost * modes.s, moment_a = 3 * lost * modes.a;
    applied.add(rod.slot[0], (2 / rod.length) * moment_a);
    applied.add(rod.slot[1], moment_s + moment_a);
    applied.add(rod.slot[2], (-2 / rod.length) * moment_a);
    applied.add(rod.slot[3], moment_a - moment_s);
    touched.insert(touched.end(), rod.slot, rod.slot + 4);
  }
}

double RodWrinkling::energy(const SlotVectors& coordinates) const {
  double energy = 0;
  if (!can_wrinkle_) return energy;
  for (const Rod& rod : rods_) {
    const double k = Modes(coordinates, rod.slot, rod.length).curvature * rod.EI / rod.moment;
    if (!(k > 1)) continue;
    energy += (InflatedBending(k).energy - k * k / 2) * rod.moment * rod.moment / rod.EI * rod.length;
  }
  return energy;
}

}  // namespace netpocket
