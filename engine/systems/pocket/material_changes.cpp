#include "engine/systems/pocket/material_changes.h"

#include "engine/systems/pocket/materials.h"

namespace netpocket {
namespace {

double moment_of(const RodParameters& rods, double wall) { return rod_material(rods, wall).wrinkling_moment; }

}  // namespace

MaterialChanges::MaterialChanges(const Scenario& scenario, std::int32_t lower_rods, std::int32_t upper_rods,
                                 std::shared_ptr<const CaptureTimes> times)
    : friction_(scenario.contact.friction),
      deflation_(scenario.deflation, scenario.rods.pressure, std::move(times)),
      rods_([&] {
        const auto rods = [&](std::int32_t material, double wall) {
          const double moment = moment_of(scenario.rods, wall);
          return Rods{material, moment, GradualChange(1 / moment)};
        };
        return std::array{rods(lower_rods, scenario.rods.wall_lower), rods(upper_rods, scenario.rods.wall_upper)};
      }()) {}

void MaterialChanges::change(const Scenario& scenario, double now) {
  friction_.change(scenario.contact.friction, now);
  rods_[0].moment = moment_of(scenario.rods, scenario.rods.wall_lower);
  rods_[1].moment = moment_of(scenario.rods, scenario.rods.wall_upper);
  for (Rods& rods : rods_) rods.weakness.change(1 / rods.moment, now);
  deflation_.change(scenario.deflation, scenario.rods.pressure);
}

// Exactly the scenario's moment where nothing changes: two divisions would round it.
double MaterialChanges::Rods::moment_at(double time) const {
  const double now = weakness.at(time);
  return now == 1 / moment ? moment : 1 / now;
}

void MaterialChanges::update(const Measurements& measurements, double interval, Commands& commands) {
  const double now = measurements.time();
  deflation_.update(now, interval);
  commands.set_friction(friction_.at(now));
  for (const Rods& rods : rods_) commands.set_wrinkling_moment(rods.material, deflation_.part() * rods.moment_at(now));
}

void MaterialChanges::visit_state(const std::function<void(double&)>& visit) {
  friction_.visit_state(visit);
  for (Rods& rods : rods_) rods.weakness.visit_state(visit);
  deflation_.visit_state(visit);
}

}  // namespace netpocket
