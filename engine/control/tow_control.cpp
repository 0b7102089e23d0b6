#include "engine/control/tow_control.h"

namespace netpocket {

TowControl::TowControl(const PidSettings& pid, const std::optional<TensionCapSettings>& cap) : pid_(pid) {
  if (cap) cap_.emplace(*cap);
}

double TowControl::update(const TowMeasurement& measured, const TowReference& wanted, double dt) {
  const double demand =
      pid_.update(measured.value - wanted.value, measured.rate - wanted.rate, dt, wanted.feed_forward);
  return cap_ ? cap_->update(demand, measured.tension, dt) : demand;
}

void TowControl::visit_state(const NumberVisitor& visit) {
  pid_.visit_state(visit);
  if (cap_) cap_->visit_state(visit);
}

}  // namespace netpocket
