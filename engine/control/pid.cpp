#include "engine/control/pid.h"

#include <algorithm>

namespace netpocket {

double Pid::update(double error, double rate, double dt, double feed_forward) {
  const double change = -settings_.integral * error * dt;
  const double immediate = feed_forward - settings_.proportional * error - settings_.derivative * rate;
  const double demand = immediate + integral_ + change;
  const bool winds_up = (demand > settings_.most && change > 0) || (demand < settings_.least && change < 0);
  if (!winds_up) integral_ += change;
  return std::clamp(demand, settings_.least, settings_.most);
}

}  // namespace netpocket
