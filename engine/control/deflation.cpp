#include "engine/control/deflation.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace netpocket {

Deflation::Deflation(const DeflationParameters& parameters, double pressure, std::shared_ptr<const CaptureTimes> times)
    : parameters_(parameters), pressure_(pressure), times_(std::move(times)) {}

double Deflation::start() const {
  switch (parameters_.starts_at) {
    case DeflationStart::time:
      return parameters_.start;
    case DeflationStart::closing:
      return times_->closing_start + parameters_.start;
    case DeflationStart::closed:
      return times_->closing_end + parameters_.start;
    case DeflationStart::never:
      break;
  }
  return std::numeric_limits<double>::infinity();
}

void Deflation::update(double time, double interval) {
  if (pressure_ <= 0) return;
  const double open = std::min(interval, time + interval - start());  // s, of this step
  if (open <= 0) return;
  const double least = std::min(part_, parameters_.pressure / pressure_);
  part_ = std::max(least, part_ - open * parameters_.rate / pressure_);
}

void Deflation::change(const DeflationParameters& parameters, double pressure) {
  parameters_ = parameters;
  pressure_ = pressure;
}

}  // namespace netpocket
