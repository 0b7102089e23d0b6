#include "engine/state/phase.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace netpocket {
namespace {

double time_of(const std::vector<Phase>& phases, std::string_view name, double Phase::*time) {
  const auto found = std::ranges::find(phases, name, &Phase::name);
  return found == phases.end() ? std::numeric_limits<double>::quiet_NaN() : (*found).*time;
}

}  // namespace

double phase_begin(const std::vector<Phase>& phases, std::string_view name) {
  return time_of(phases, name, &Phase::begin);
}

double phase_end(const std::vector<Phase>& phases, std::string_view name) { return time_of(phases, name, &Phase::end); }

std::string phase_at(const std::vector<Phase>& phases, double time) {
  const Phase* last = nullptr;
  for (const Phase& phase : phases) {
    if (phase.begin <= time && time < phase.end && (last == nullptr || phase.begin >= last->begin)) last = &phase;
  }
  return last != nullptr ? last->name : "";
}

bool PhaseHistory::note(double time, double value) {
  const std::optional<double> before = std::exchange(last_, value);
  if (before == value) return false;
  const bool ends = !phases_.empty() && std::isinf(phases_.back().end);
  if (ends) phases_.back().end = time;
  if (!(value >= 0 && value < static_cast<double>(kPocketPhases.size()))) return ends;
  const std::string name = kPocketPhases[static_cast<std::size_t>(value)];
  phases_.push_back({name, time, std::numeric_limits<double>::infinity(), name != kClosing && name != kTowing});
  return true;
}

std::vector<Phase> phases_of_channel(const std::vector<double>& times, const std::vector<double>& values) {
  PhaseHistory history;
  for (std::size_t i = 0; i < times.size(); ++i) history.note(times[i], values[i]);
  return history.phases();
}

std::vector<Phase> pocket_phases(double closing_start, double closing_end, double towing_start) {
  constexpr double kNever = std::numeric_limits<double>::infinity();
  const bool tows = std::isfinite(towing_start);
  std::vector<Phase> phases;
  if (std::isfinite(closing_end)) {
    const double hold_end = tows ? towing_start : kNever;
    if (closing_start > 0) phases.push_back({"open", 0, closing_start, true});
    phases.push_back({kClosing, closing_start, closing_end});
    if (hold_end > closing_end) phases.push_back({"closed", closing_end, hold_end, true});
  }
  if (tows) phases.push_back({kTowing, towing_start, kNever});
  return phases;
}

}  // namespace netpocket
