#include "engine/systems/pocket/pocket_system.h"

#include <limits>
#include <utility>

#include "engine/control/closing_control.h"
#include "engine/control/towing.h"
#include "engine/scenario/pocket_outline.h"
#include "engine/systems/pocket/material_changes.h"
#include "engine/systems/pocket/pocket.h"
#include "engine/systems/pocket/pocket_channels.h"

namespace netpocket {
namespace {

double total_mass(const Model& model) {
  double mass = model.cable_mass();
  for (const ModelBody& body : model.bodies) mass += body.mass;
  return mass;
}

CaptureSystem build(const Scenario& scenario) {
  Pocket pocket = build_pocket(scenario);
  CaptureSystem system;
  std::vector<double> open_lengths;
  for (const VariableRope& rope : pocket.model.ropes) open_lengths.push_back(rope.motion.length);
  const auto add = [&](std::unique_ptr<Controller> controller) {
    system.controllers.push_back({std::move(controller), 0});
  };
  add(std::make_unique<MaterialChanges>(scenario, pocket.lower_rods, pocket.upper_rods));
  add(std::make_unique<SpacecraftDrive>(scenario.towing, scenario.spacecraft.station_keeping, total_mass(pocket.model),
                                        pocket.spacecraft));
  add(std::make_unique<ClosingControl>(scenario.closing, open_lengths));
  const PocketChannels channels(pocket);
  system.fill_channels = [channels](const CableSystem& cables, Snapshot& snapshot) { channels.fill(cables, snapshot); };
  system.spacecraft = pocket.spacecraft;
  system.target = pocket.target;
  system.structure = std::move(pocket.structure);
  system.model = std::move(pocket.model);
  return system;
}

std::vector<Phase> phases(const Scenario& scenario) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const ClosingSchedule closing(scenario.closing, open_tip_distance(scenario));
  return pocket_phases(closing.start(), closing.end(),
                       scenario.towing.mode == TowingMode::none ? kNone : scenario.towing.start);
}

}  // namespace

CaptureSystemKind pocket_kind() { return {&pocket_parameters(), build, phases}; }

}  // namespace netpocket
