#include "engine/systems/thrown_net/thrown_net_system.h"

#include <limits>
#include <utility>

#include "engine/control/target_drive.h"
#include "engine/control/towing.h"
#include "engine/scenario/check_orbit.h"
#include "engine/scenario/thrown_net_parameters.h"
#include "engine/systems/pocket/control_channels.h"
#include "engine/systems/tether_winch.h"
#include "engine/systems/thrown_net/thrown_net.h"
#include "engine/systems/thrown_net/thrown_net_channels.h"
#include "engine/systems/thrown_net/thrown_net_control.h"

namespace netpocket {
namespace {

double mass_of_all(const Model& model) {
  double mass = model.cable_mass();
  for (const ModelBody& body : model.bodies) mass += body.mass;
  return mass;
}

// Whether phases begin or end at times that only the run knows.
bool waits_for_events(const Scenario& scenario) {
  return thrown_net_parameters(scenario).draws_at == DrawstringStart::contact || scenario.towing.abort_force > 0;
}

void add_net_channels(CaptureSystem& system, const ThrownNetChannels& channels, const ControlChannels& control) {
  std::vector<ChannelInfo> infos = channels.infos();
  infos.insert(infos.end(), control.infos().begin(), control.infos().end());
  system.structure.channels = std::make_shared<const ChannelList>(std::move(infos));
  system.fill_channels = [channels, control](const CableSystem& cables, Snapshot& out) {
    channels.fill(cables, out);
    control.fill(out);
  };
}

CaptureSystem build_thrown_net_system(const Scenario& scenario) {
  ThrownNet net = build_thrown_net(scenario);
  CaptureSystem system;
  const auto add = [&system](auto controller) { system.controllers.push_back({std::move(controller), 0}); };
  auto events = std::make_unique<ThrownNetEvents>(scenario, net.target);
  const auto times = events->times();
  system.awaited = [watch = events.get()](double /*time*/) { return watch->awaited(); };
  add(std::move(events));
  auto drive = std::make_unique<SpacecraftDrive>(scenario.towing, scenario.spacecraft.station_keeping,
                                                 mass_of_all(net.model), net.spacecraft, times);
  if (scenario.orbit.turns()) drive->follow(*orbit_of(scenario));
  add(std::move(drive));
  std::vector<double> open_lengths;
  for (std::size_t rope = 0; rope < net.drawstring_count(); ++rope) open_lengths.push_back(net.model.rope_length(rope));
  const WinchControl* winches = nullptr;
  if (!open_lengths.empty()) {
    auto drawstring = std::make_unique<DrawstringControl>(scenario, open_lengths, times);
    winches = drawstring->winches();
    add(std::move(drawstring));
  }
  if (net.tether_rope >= 0) {
    add(std::make_unique<TetherWinch>(scenario, TetherWinch::Parts{net.tether_rope, -1, net.target}, times));
  }
  add(std::make_unique<TargetDrive>(scenario.target, net.target));
  system.spacecraft = net.spacecraft;
  system.target = net.target;
  system.structure = net.model.structure();
  add_net_channels(
      system, ThrownNetChannels(net),
      ControlChannels(nullptr, winches, nullptr, waits_for_events(scenario) ? times : nullptr, net.spacecraft));
  system.model = std::move(net.model);
  return system;
}

// Without a drawstring the net is open until it is towed.
std::vector<Phase> phases_of_thrown_net(const Scenario& scenario) {
  constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  const ThrownNetParameters net = thrown_net_parameters(scenario);
  const bool at_known_time = net.draws_at == DrawstringStart::time;
  const double closing_start = at_known_time ? net.drawstring.start : kUnknown;
  const double closing_end = closing_start + net.drawstring.duration;
  const TowingParameters& towing = scenario.towing;
  const double towing_start = towing.starts_at == TowingStart::closed ? closing_end : towing.start;
  return pocket_phases(closing_start, closing_end, towing.mode == TowingMode::none ? kUnknown : towing_start);
}

}  // namespace

CaptureSystemKind thrown_net_kind() {
  return {&thrown_net_system_parameters(), build_thrown_net_system, phases_of_thrown_net};
}

}  // namespace netpocket
