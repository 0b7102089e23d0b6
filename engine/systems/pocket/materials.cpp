#include "engine/systems/pocket/materials.h"

#include <cmath>
#include <limits>
#include <numbers>

#include "engine/ancf/wrinkling.h"
#include "engine/math/elementary.h"

namespace netpocket {
namespace {

constexpr double kPi = std::numbers::pi;

}  // namespace

CableMaterial cord_material(const CordParameters& cord) {
  const double area = kPi * cord.diameter * cord.diameter / 4;
  const double second_moment = kPi * fourth_power(cord.diameter) / 64;
  return {.section = {.EA = cord.youngs_modulus * area,
                      .EI = cord.youngs_modulus * second_moment,
                      .mass_per_length = cord.density * area,
                      .axial_damping = cord.axial_damping,
                      .bending_damping = cord.bending_damping,
                      .compression = cord.compression},
          .radius = cord.diameter / 2,
          .youngs_modulus = cord.youngs_modulus,
          .poisson_ratio = cord.poisson_ratio};
}

CableMaterial rod_material(const RodParameters& rods, double wall) {
  const double outer = rods.outer_diameter, inner = std::max(0.0, outer - 2 * wall);
  const double area = kPi * (outer * outer - inner * inner) / 4;
  const double second_moment = kPi * (fourth_power(outer) - fourth_power(inner)) / 64;
  return {.section = {.EA = rods.youngs_modulus * area,
                      .EI = rods.youngs_modulus * second_moment,
                      .mass_per_length = rods.density * area,
                      .axial_damping = rods.axial_damping,
                      .bending_damping = rods.bending_damping,
                      .compression = 1},
          .radius = outer / 2,
          .youngs_modulus = rods.youngs_modulus,
          .poisson_ratio = rods.poisson_ratio,
          .wrinkling_moment = rods.pressure > 0 ? wrinkling_moment(rods.pressure, (outer + inner) / 4)
                                                : std::numeric_limits<double>::infinity(),
          .is_tube = true};
}

}  // namespace netpocket
