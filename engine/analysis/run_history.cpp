#include "engine/analysis/run_history.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace netpocket {

namespace {

// Frame times are sums of steps. A frame this close to a limit counts as being at it.
constexpr double kTimeTolerance = 1e-6;  // s

// The run must continue this long after the closing to show that the target stays.
constexpr double kHoldingTime = 1.0;  // s

double magnitude(double value) { return std::abs(value); }

bool is_smaller(const ContactEpisode& a, const ContactEpisode& b) {
  return magnitude(a.impulse) < magnitude(b.impulse);
}

}  // namespace

const char* const kCaptureRule =
    "target_inside is 1 in every frame from the end of the closing law to the end of the run, closing_length stays "
    "within 5 % of the commanded length or below half of its initial value in those frames, and the run goes on for 1 "
    "s "
    "or more after the closing";

FrameRange RunHistory::frames(double from, double to) const {
  const auto& t = times();
  const auto first = std::upper_bound(t.begin(), t.end(), from + kTimeTolerance);
  const auto last = std::upper_bound(t.begin(), t.end(), to + kTimeTolerance);
  return {static_cast<std::size_t>(first - t.begin()), static_cast<std::size_t>(last - t.begin())};
}

FrameRange RunHistory::frames_from(double from) const {
  const auto first = std::lower_bound(times().begin(), times().end(), from - kTimeTolerance);
  return {static_cast<std::size_t>(first - times().begin()), times().size()};
}

double RunHistory::interval(std::size_t frame) const { return frame == 0 ? 0 : times()[frame] - times()[frame - 1]; }

double RunHistory::averaging_window() const {
  std::vector<double> intervals;
  for (std::size_t i = 1; i < times().size(); ++i) intervals.push_back(interval(i));
  if (intervals.empty()) return 0;
  const auto middle = intervals.begin() + static_cast<std::ptrdiff_t>(intervals.size() / 2);
  std::nth_element(intervals.begin(), middle, intervals.end());
  return *middle;
}

Eigen::Vector3d RunHistory::force(std::size_t frame) const {
  return {channel(Channel::contact_fx)[frame], channel(Channel::contact_fy)[frame],
          channel(Channel::contact_fz)[frame]};
}

Peak RunHistory::peak(Channel c, FrameRange range) const {
  Peak peak;
  for (std::size_t i = range.first; i < range.last; ++i) {
    const double value = channel(c)[i];
    if (magnitude(value) > magnitude(peak.value)) peak = {value, times()[i]};
  }
  return peak;
}

double RunHistory::lateral_peak(FrameRange range) const {
  return std::max(magnitude(peak(Channel::contact_fx, range).value), magnitude(peak(Channel::contact_fz, range).value));
}

Peak RunHistory::force_peak() const {
  Peak peak;
  for (std::size_t i = 0; i < times().size(); ++i) {
    const double value = force(i).norm();
    if (value > peak.value) peak = {value, times()[i]};
  }
  return peak;
}

Eigen::Vector3d RunHistory::impulse() const {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < times().size(); ++i) sum += interval(i) * force(i);
  return sum;
}

bool RunHistory::in_contact(std::size_t frame) const {
  return channel(Channel::contact_count)[frame] > 0 || force(frame).norm() > 0;
}

std::optional<double> RunHistory::first_contact() const {
  for (std::size_t i = 0; i < times().size(); ++i) {
    if (in_contact(i)) return times()[i];
  }
  return std::nullopt;
}

std::vector<ContactEpisode> RunHistory::episodes(FrameRange range, double smallest) const {
  std::vector<ContactEpisode> found;
  for (std::size_t i = range.first; i < range.last; ++i) {
    const double impulse = interval(i) * channel(Channel::contact_fy)[i];
    if (impulse == 0) continue;
    if (!found.empty() && (found.back().impulse > 0) == (impulse > 0)) {
      found.back().impulse += impulse;
      found.back().frames.last = i + 1;
    } else {
      found.push_back({impulse, times()[i], {i, i + 1}});
    }
  }
  while (found.size() > 1) {
    const double largest = magnitude(std::max_element(found.begin(), found.end(), is_smaller)->impulse);
    const auto least = std::min_element(found.begin(), found.end(), is_smaller);
    if (magnitude(least->impulse) >= smallest * largest) break;
    const bool inside = least != found.begin() && least + 1 != found.end();
    if (!inside) {
      found.erase(least);
      continue;
    }
    // Its neighbours have the other sign, and the impulse of each is larger.
    ContactEpisode& before = *(least - 1);
    const ContactEpisode& after = *(least + 1);
    before.impulse += least->impulse + after.impulse;
    before.frames.last = after.frames.last;
    found.erase(least, least + 2);
  }
  return found;
}

Eigen::Vector3d RunHistory::position(Body body, std::size_t frame) const {
  const bool target = body == Body::target;
  return {channel(target ? Channel::target_x : Channel::spacecraft_x)[frame],
          channel(target ? Channel::target_y : Channel::spacecraft_y)[frame],
          channel(target ? Channel::target_z : Channel::spacecraft_z)[frame]};
}

Eigen::Vector3d RunHistory::excursion(Body body, FrameRange range, std::size_t origin) const {
  Eigen::Vector3d largest = Eigen::Vector3d::Zero();
  for (std::size_t i = range.first; i < range.last; ++i) {
    largest = largest.cwiseMax((position(body, i) - position(body, origin)).cwiseAbs());
  }
  return largest;
}

std::string RunHistory::divergence() const {
  const RunStatus& status = data_->status();
  if (status.reason != RunReason::diverged) return "";
  return fmt::format("the run diverged at t = {:.4g} s", status.time);
}

Capture RunHistory::capture_by_channel() const {
  const auto index = data_->channels()->find("captured");
  if (!index) return {Verdict::unknown, "this kind of capture system has no channel that says so"};
  if (times().empty() || end() < kHoldingTime) return {Verdict::unknown, "the run is shorter than 1 s"};
  const std::vector<double>& captured = data_->channel(*index);
  for (std::size_t i = frames_from(end() - kHoldingTime).first; i < times().size(); ++i) {
    if (captured[i] != 1) return {Verdict::no, fmt::format("the target is not held at t = {:.4g} s", times()[i])};
  }
  return {Verdict::yes, ""};
}

Capture RunHistory::capture() const {
  if (const std::string diverged = divergence(); !diverged.empty()) return {Verdict::diverged, diverged};
  // Where a capture takes so long, its steps are small for a reason: what came before is no judgement.
  if (data_->status().reason == RunReason::limited) return {Verdict::unknown, data_->status().message};
  if (!data_->has_channel(Channel::target_inside)) return capture_by_channel();
  if (std::isnan(closing_end())) return {Verdict::unknown, "the recording does not say when the closing ends"};
  const auto& inside = channel(Channel::target_inside);
  const auto& length = channel(Channel::closing_length);
  const auto& commanded = channel(Channel::commanded_length);
  for (std::size_t i = frames_from(closing_end()).first; i < times().size(); ++i) {
    if (inside[i] != 1) return {Verdict::no, fmt::format("target outside the pocket at t = {:.4g} s", times()[i])};
    const double allowed = std::max(1.05 * commanded[i], 0.5 * length[0]);
    if (!(length[i] <= allowed)) {
      return {Verdict::no, fmt::format("mouth open by {:.3g} m at t = {:.4g} s", length[i], times()[i])};
    }
  }
  if (times().empty() || end() < closing_end() + kHoldingTime - kTimeTolerance) {
    return {Verdict::unknown,
            fmt::format("run ends at t = {:.4g} s, before {:.4g} s", end(), closing_end() + kHoldingTime)};
  }
  return {Verdict::yes, ""};
}

}  // namespace netpocket
