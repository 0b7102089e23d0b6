#include "engine/systems/pocket/pocket_system.h"

#include <limits>
#include <utility>

#include "engine/control/closed_loop.h"
#include "engine/control/closing_control.h"
#include "engine/control/disturbances.h"
#include "engine/control/target_drive.h"
#include "engine/control/towing.h"
#include "engine/control/winch_control.h"
#include "engine/scenario/check_orbit.h"
#include "engine/scenario/pocket_outline.h"
#include "engine/systems/pocket/control_channels.h"
#include "engine/systems/pocket/loop_channels.h"
#include "engine/systems/pocket/material_changes.h"
#include "engine/systems/pocket/pocket.h"
#include "engine/systems/pocket/pocket_channels.h"
#include "engine/systems/pocket/pocket_events.h"
#include "engine/systems/pocket/tether_release.h"
#include "engine/systems/tether_winch.h"

namespace netpocket {
namespace {

double total_mass(const Model& model) {
  double mass = model.cable_mass();
  for (const ModelBody& body : model.bodies) mass += body.mass;
  return mass;
}

ControlledCraft controlled_craft(const Scenario& scenario, const Model& model) {
  const double captured = total_mass(model);
  return {scenario.spacecraft.inertia.asDiagonal(), captured - scenario.target.mass, captured,
          scenario.spacecraft.position};
}

// Whether phases begin or end at times that only the run knows.
bool has_events(const Scenario& scenario) {
  return scenario.closing.starts_at != ClosingStart::time || scenario.towing.abort_force > 0;
}

// Adds controllers to a system.
template <class Kind, class... Arguments>
Kind* add_controller(CaptureSystem& system, Arguments&&... arguments) {
  auto controller = std::make_unique<Kind>(std::forward<Arguments>(arguments)...);
  Kind* added = controller.get();
  system.controllers.push_back({std::move(controller), 0});
  return added;
}

// The channels of a pocket, and those of its control.
void add_channels(CaptureSystem& system, const PocketChannels& channels, const ControlChannels& control,
                  const LoopChannels& loops, const TetherChannels& tether) {
  if (control.infos().empty() && loops.infos().empty() && tether.infos().empty()) {
    system.fill_channels = [channels](const CableSystem& cables, Snapshot& out) { channels.fill(cables, out); };
    return;
  }
  std::vector<ChannelInfo> infos(known_channels()->begin(), known_channels()->end());
  infos.insert(infos.end(), loops.infos().begin(), loops.infos().end());
  const std::size_t first_of_tether = infos.size();
  infos.insert(infos.end(), tether.infos().begin(), tether.infos().end());
  infos.insert(infos.end(), control.infos().begin(), control.infos().end());
  system.structure.channels = std::make_shared<const ChannelList>(std::move(infos));
  system.structure.loops = loops.loops();
  system.fill_channels = [=](const CableSystem& cables, Snapshot& out) {
    channels.fill(cables, out);
    loops.fill(out);
    control.fill(out);
    tether.fill(cables, first_of_tether, out);
  };
}

CaptureSystem build(const Scenario& scenario) {
  Pocket pocket = build_pocket(scenario);
  CaptureSystem system;
  std::vector<double> open_lengths;
  for (const VariableRope& rope : pocket.model.ropes) open_lengths.push_back(rope.motion.length);
  const PocketEvents* watch = add_controller<PocketEvents>(system, scenario, pocket);
  system.awaited = [watch](double time) { return watch->awaited(time); };
  const auto times = watch->times();
  const auto* materials = add_controller<MaterialChanges>(system, scenario, pocket.rod_materials, times);
  auto* drive = add_controller<SpacecraftDrive>(system, scenario.towing, scenario.spacecraft.station_keeping,
                                                total_mass(pocket.model), pocket.spacecraft, times);
  if (scenario.orbit.turns()) drive->follow(*orbit_of(scenario));
  const WinchControl* winches = nullptr;
  if (scenario.winch.drive == WinchDrive::prescribed) {
    add_controller<ClosingControl>(system, scenario.closing, open_lengths, times);
  } else {
    winches = add_controller<WinchControl>(system, scenario, open_lengths, times);
  }
  add_controller<TargetDrive>(system, scenario.target, pocket.target);
  auto* disturbances = add_controller<Disturbances>(system, scenario.disturbances, pocket.spacecraft, pocket.target);
  ClosedLoop* loop = nullptr;
  if (!scenario.controllers.empty()) {
    loop = add_controller<ClosedLoop>(system, scenario, controlled_craft(scenario, pocket.model), times,
                                      pocket.spacecraft, pocket.target);
  }
  if (pocket.hub >= 0) add_controller<TetherRelease>(system, scenario, pocket.hub, times);
  if (!pocket.model.ring_ropes.empty()) {
    const auto rope = static_cast<std::int32_t>(pocket.model.ropes.size());
    add_controller<TetherWinch>(system, scenario, TetherWinch::Parts{rope, pocket.hub, pocket.target}, times);
  }
  const PocketChannels channels(pocket);
  system.spacecraft = pocket.spacecraft;
  system.target = pocket.target;
  if (pocket.hub < 0) system.sectors = scenario.pocket.rod_count;
  system.structure = std::move(pocket.structure);
  const auto events = has_events(scenario) ? times : nullptr;
  const Deflation* deflation =
      scenario.deflation.starts_at == DeflationStart::never ? nullptr : &materials->deflation();
  add_channels(system, channels, ControlChannels(loop, winches, deflation, events, pocket.spacecraft),
               LoopChannels(scenario, loop, winches, disturbances, pocket.spacecraft, pocket.target),
               TetherChannels(pocket));
  system.model = std::move(pocket.model);
  return system;
}

std::vector<Phase> phases(const Scenario& scenario) {
  constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  const TowingParameters& towing = scenario.towing;
  const ClosingSchedule closing(scenario.closing, open_tip_distance(scenario));
  const bool at_event = scenario.closing.starts_at != ClosingStart::time;
  const double closing_end = at_event ? kUnknown : closing.end();
  const double towing_start = towing.starts_at == TowingStart::closed ? closing_end : towing.start;
  return pocket_phases(closing.start(), closing_end, towing.mode == TowingMode::none ? kUnknown : towing_start);
}

}  // namespace

CaptureSystemKind pocket_kind() { return {&pocket_parameters(), build, phases}; }

}  // namespace netpocket
