#include "engine/systems/pocket/material_changes.h"

#include "engine/systems/pocket/materials.h"

namespace netpocket {
namespace {

double moment_of(const RodParameters& rods, double wall) { return rod_material(rods, wall).wrinkling_moment; }

}  // namespace

MaterialChanges::MaterialChanges(const Pocket& pocket, CableSystem& system, const Scenario& scenario)
    : system_(system), friction_(scenario.contact.friction), applied_friction_(scenario.contact.friction), rods_([&] {
        const auto rods = [&](std::int32_t material, double wall) {
          const double moment = moment_of(scenario.rods, wall);
          return Rods{material, moment, GradualChange(1 / moment), 1 / moment};
        };
        return std::array{rods(pocket.lower_rods, scenario.rods.wall_lower),
                          rods(pocket.upper_rods, scenario.rods.wall_upper)};
      }()) {}

void MaterialChanges::change(const Scenario& scenario, double now) {
  friction_.change(scenario.contact.friction, now);
  rods_[0].moment = moment_of(scenario.rods, scenario.rods.wall_lower);
  rods_[1].moment = moment_of(scenario.rods, scenario.rods.wall_upper);
  for (Rods& rods : rods_) rods.weakness.change(1 / rods.moment, now);
}

void MaterialChanges::apply(double time) {
  apply_friction(friction_.at(time));
  for (Rods& rods : rods_) apply_weakness(rods, rods.weakness.at(time));
}

void MaterialChanges::apply_friction(double friction) {
  if (friction == applied_friction_) return;
  applied_friction_ = friction;
  system_.set_friction(friction);
}

void MaterialChanges::apply_weakness(Rods& rods, double weakness) {
  if (weakness == rods.applied) return;
  rods.applied = weakness;
  system_.set_wrinkling_moment(rods.material, weakness == 1 / rods.moment ? rods.moment : 1 / weakness);
}

void MaterialChanges::visit_state(const std::function<void(double&)>& visit) {
  friction_.visit_state(visit);
  double friction = applied_friction_;
  visit(friction);
  apply_friction(friction);
  for (Rods& rods : rods_) {
    rods.weakness.visit_state(visit);
    double weakness = rods.applied;
    visit(weakness);
    apply_weakness(rods, weakness);
  }
}

}  // namespace netpocket
