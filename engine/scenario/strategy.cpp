#include "engine/scenario/strategy.h"

#include "engine/scenario/system_parameters.h"
#include "engine/scenario/tether_drum.h"

namespace netpocket {

namespace {

// Sensors, actuators, and what a controller or a winch is, belong to the system; gains and set points to the strategy.
bool is_of_strategy(std::string_view key) {
  const std::string_view name = key.substr(key.rfind('.') + 1);
  const auto is_one_of = [name](auto... names) { return ((name == names) || ...); };
  if (key.starts_with("controller.")) return !is_one_of("kind", "phase", "rate", "quantity", "observer", "axes");
  if (key == "disturbance" || key.starts_with("disturbance.")) return true;
  if (key.starts_with("winch.")) return !is_one_of("drive", "drum_radius", "drum_inertia", "late");
  return key == "target.thrust" || key == "target.torque" || key.starts_with("target.acts_");
}

}  // namespace

bool acts_at_once_in_pocket(std::string_view key) {
  if (key == "closing.elements") return false;
  return is_of_strategy(key) || key.starts_with("closing.") || key.starts_with("towing.") ||
         key.starts_with("deflation.") || key == "contact.friction" || key == "rods.pressure" ||
         key == "spacecraft.station_keeping" || drum_acts_at_once(key);
}

bool acts_at_once(std::string_view key, std::string_view system) {
  if (key == "output.end_time") return true;
  const SystemParameters* kind = find_system(system);
  return kind != nullptr && kind->acts_at_once != nullptr && kind->acts_at_once(key);
}

}  // namespace netpocket
