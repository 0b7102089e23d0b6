#include "engine/systems/pocket/material_changes.h"

#include "engine/systems/pocket/materials.h"

namespace netpocket {
namespace {

double moment_of(RodParameters rods, const RodMaterial& of) {
  rods.pressure *= of.pressure;
  return rod_material(rods, of.wall).wrinkling_moment;
}

}  // namespace

MaterialChanges::MaterialChanges(const Scenario& scenario, const std::vector<RodMaterial>& rods,
                                 std::shared_ptr<const CaptureTimes> times)
    : friction_(scenario.contact.friction), deflation_(scenario.deflation, scenario.rods.pressure, std::move(times)) {
  for (const RodMaterial& of : rods) {
    const double moment = moment_of(scenario.rods, of);
    rods_.push_back({of, moment, GradualChange(1 / moment)});
  }
}

void MaterialChanges::change(const Scenario& scenario, double now) {
  friction_.change(scenario.contact.friction, now);
  for (Rods& rods : rods_) {
    rods.moment = moment_of(scenario.rods, rods.of);
    rods.weakness.change(1 / rods.moment, now);
  }
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
  for (const Rods& rods : rods_)
    commands.set_wrinkling_moment(rods.of.material, deflation_.part() * rods.moment_at(now));
}

void MaterialChanges::visit_state(const std::function<void(double&)>& visit) {
  friction_.visit_state(visit);
  for (Rods& rods : rods_) rods.weakness.visit_state(visit);
  deflation_.visit_state(visit);
}

}  // namespace netpocket
