#include "engine/scenario/strategy.h"

#include "engine/scenario/system_parameters.h"

namespace netpocket {

bool acts_at_once_in_pocket(std::string_view key) {
  if (key == "closing.elements") return false;
  return key.starts_with("closing.") || key.starts_with("towing.") || key == "contact.friction" ||
         key == "rods.pressure" || key == "spacecraft.station_keeping";
}

bool acts_at_once(std::string_view key, std::string_view system) {
  if (key == "output.end_time") return true;
  const SystemParameters* kind = find_system(system);
  return kind != nullptr && kind->acts_at_once != nullptr && kind->acts_at_once(key);
}

}  // namespace netpocket
