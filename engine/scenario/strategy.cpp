#include "engine/scenario/strategy.h"

namespace netpocket {

bool acts_at_once(std::string_view key) {
  if (key == "closing.elements") return false;
  return key.starts_with("closing.") || key.starts_with("towing.") || key == "contact.friction" ||
         key == "rods.pressure" || key == "spacecraft.station_keeping" || key == "output.end_time";
}

}  // namespace netpocket
