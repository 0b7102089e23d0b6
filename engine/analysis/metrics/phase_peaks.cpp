#include "engine/analysis/metrics/phase_peaks.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/math/elementary.h"

namespace netpocket {
namespace {

// rad; exact for small angles.
double angle_between(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b) {
  const Eigen::Quaterniond turn = a.conjugate() * b;
  return 2 * arc_tangent(turn.vec().norm(), std::abs(turn.w()));
}

void raise(double& peak, double value) { peak = std::isnan(peak) ? value : std::max(peak, value); }

}  // namespace

PhasePeaks::PhasePeaks(std::optional<std::size_t> spacecraft, std::vector<Phase> phases)
    : spacecraft_(spacecraft), phases_(std::move(phases)) {}

std::string PhasePeaks::phase_of(const Snapshot& snapshot) const {
  if (const auto index = snapshot.channel_list->find(kPhaseChannel)) {
    const std::vector<Phase> now = phases_of_channel({snapshot.time}, {snapshot.channels[*index]});
    return now.empty() ? "" : now.front().name;
  }
  // Times of frames are sums of steps.
  constexpr double kRoundOff = 1e-9;
  return phase_at(phases_, snapshot.time + kRoundOff);
}

void PhasePeaks::add_attitude(const Snapshot& snapshot, bool touched, bool tows) {
  const Eigen::Quaterniond& attitude = snapshot.bodies[*spacecraft_].attitude;
  if (!start_) start_ = attitude;
  raise(attitude_, angle_between(*start_, attitude));
  has_towed_ = has_towed_ || tows;
  if (touched && !has_towed_) raise(impact_, angle_between(*start_, attitude));
}

void PhasePeaks::add(const Snapshot& snapshot, bool touched) {
  const std::string phase = phase_of(snapshot);
  const bool tows = phase == kTowing;
  if (spacecraft_) add_attitude(snapshot, touched, tows);
  if (phase == kClosing) {
    times_.push_back(snapshot.time);
    tensions_.push_back(snapshot.channel(Channel::closing_tension));
    raise(tension_, tensions_.back());
  }
  if (!tows) return;
  raise(force_, std::max(0.0, -snapshot.channel(Channel::contact_fy)));
  if (const auto thrust = snapshot.channel_list->find("exerted_force_y"))
    raise(thrust_, std::max(0.0, -snapshot.channels[*thrust]));
}

double PhasePeaks::end_tension() const {
  if (times_.empty()) return kNone;
  constexpr double kLastPart = 0.2;
  const double from = times_.back() - kLastPart * (times_.back() - times_.front());
  double sum = 0, count = 0;
  for (std::size_t i = 0; i < times_.size(); ++i) {
    if (times_[i] < from) continue;
    sum += tensions_[i];
    ++count;
  }
  return sum / count;
}

}  // namespace netpocket
