#include "engine/control/tension_cap.h"

#include <algorithm>

namespace netpocket {

double TensionCap::update(double demand, double tension, double dt) {
  const double excess = tension - settings_.cap;
  relief_ = std::clamp(relief_ + settings_.integral * excess * dt, 0.0, std::max(0.0, demand));
  if (demand <= 0) return demand;
  return std::max(0.0, demand - relief_ - settings_.proportional * std::max(0.0, excess));
}

}  // namespace netpocket
