#include "engine/systems/pocket/sector_variation.h"

#include <algorithm>
#include <map>

#include "engine/scenario/sector_scatter.h"
#include "engine/state/pocket_groups.h"

namespace netpocket {
namespace {

struct Variation {
  double stiffness = 1, pressure = 1;

  bool operator==(const Variation&) const = default;
};

CableMaterial varied(CableMaterial material, const Variation& by) {
  material.section.EA *= by.stiffness;
  material.section.EI *= by.stiffness;
  material.youngs_modulus *= by.stiffness;
  material.wrinkling_moment *= by.pressure;  // which is in proportion to it
  return material;
}

}  // namespace

void vary_sectors(const Scenario& scenario, Pocket& pocket) {
  const std::vector<double> rods = sector_factors(scenario, kRodStiffness),
                            pressures = sector_factors(scenario, kRodPressure),
                            panels = sector_factors(scenario, kPanelStiffness);
  Model& model = pocket.model;
  std::map<std::pair<std::int32_t, std::size_t>, std::int32_t> made;  // by material and sector
  for (std::size_t i = 0; i < model.elements.size(); ++i) {
    auto& element = model.elements[i];
    const std::size_t sector = i % rods.size();
    const bool is_rod = element.group == index_of(PocketGroup::rods);
    if (!is_rod && element.group != index_of(PocketGroup::net)) continue;
    const Variation by = is_rod ? Variation{rods[sector], pressures[sector]} : Variation{panels[sector], 1};
    if (by == Variation{}) continue;
    const std::int32_t common = element.material;
    const auto [own, is_new] = made.try_emplace({common, sector}, 0);
    if (is_new) {
      own->second = model.add_material(varied(model.materials[static_cast<std::size_t>(common)], by));
      const auto rod = std::ranges::find(pocket.rod_materials, common, &RodMaterial::material);
      if (is_rod) pocket.rod_materials.push_back({own->second, rod->wall, by.pressure});
    }
    element.material = own->second;
  }
}

}  // namespace netpocket
