#include "engine/systems/capture_system.h"

#include <algorithm>
#include <deque>

#include "engine/systems/orbital_frame.h"
#include "engine/systems/pocket/pocket_system.h"
#include "engine/systems/thrown_net/thrown_net_system.h"

namespace netpocket {
namespace {

// A deque keeps the places of its entries.
std::deque<CaptureSystemKind>& kinds() {
  static std::deque<CaptureSystemKind> kinds = {pocket_kind(), thrown_net_kind()};
  return kinds;
}

auto find_kind(std::string_view name) {
  return std::ranges::find(kinds(), name, [](const CaptureSystemKind& kind) { return kind.parameters->name; });
}

}  // namespace

void register_capture_system(const CaptureSystemKind& kind) {
  register_system_parameters(*kind.parameters);
  kinds().push_back(kind);
}

const CaptureSystemKind& capture_system_kind(const Scenario& scenario) {
  const auto found = find_kind(scenario.system);
  if (found == kinds().end()) throw std::invalid_argument("there is no capture system called " + scenario.system);
  return *found;
}

std::vector<Phase> capture_phases(const Scenario& scenario) { return capture_system_kind(scenario).phases(scenario); }

CaptureSystem build_capture_system(const Scenario& scenario) {
  CaptureSystem system = capture_system_kind(scenario).build(scenario);
  for (const ChannelInfo& channel : common_channels(system.spacecraft >= 0, system.target >= 0)) {
    if (!system.structure.channels->find(channel.name)) {
      throw SystemFault("the capture system " + scenario.system + " has no channel " + channel.name);
    }
  }
  put_into_orbit(scenario, system);
  if (const auto fault = system.model.find_fault()) {
    throw SystemFault("the capture system " + scenario.system + " builds a model with a fault: " + *fault);
  }
  return system;
}

}  // namespace netpocket
