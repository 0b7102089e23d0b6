#include "engine/analysis/metrics/mouth_passage.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/analysis/metrics/net_geometry.h"

namespace netpocket {
namespace {

constexpr double kTimeRoundOff = 1e-6;  // s, of a sum of steps

// NaN counts as nothing.
double smaller(double a, double b) { return std::isnan(a) ? b : std::min(a, b); }
double larger(double a, double b) { return std::isnan(a) ? b : std::max(a, b); }

}  // namespace

double mouth_area(const Structure& structure, const Snapshot& snapshot) {
  const Eigen::Matrix3Xd polygon = mouth_polygon(structure, snapshot);
  return polygon.cols() < 3 ? std::numeric_limits<double>::quiet_NaN() : vector_area(polygon).norm();
}

MouthPassage::MouthPassage(const Structure& structure, std::optional<std::size_t> target, double closing_end)
    : structure_(structure), target_(target), closing_end_(closing_end), ropes_(rope_elements(structure)) {}

void MouthPassage::add(const Snapshot& snapshot, const std::vector<std::int32_t>& net) {
  times_.push_back(snapshot.time);
  lengths_.push_back(snapshot.channel(Channel::closing_length));
  commanded_ = std::min(commanded_, snapshot.channel(Channel::commanded_length));
  if (!target_) return;
  measure_gap(snapshot);
  if (snapshot.time >= closing_end_ - kTimeRoundOff) measure_escape(snapshot, net);
}

void MouthPassage::measure_gap(const Snapshot& snapshot) {
  const BodyState& body = snapshot.bodies[*target_];
  const Shape& shape = structure_.bodies[*target_].shape;
  const auto gap_at = [&](const Eigen::Vector3d& point, double radius) {
    return nearest_surface_point(shape, body.attitude.conjugate() * (point - body.position)).distance - radius;
  };
  for (const CordSegment& segment : cord_segments(structure_, snapshot, ropes_)) {
    const double gap = std::min(gap_at(segment.from, segment.radius), gap_at(segment.to, segment.radius));
    if (!(gap_.value <= gap)) gap_ = {gap, snapshot.time};
  }
}

void MouthPassage::measure_escape(const Snapshot& snapshot, const std::vector<std::int32_t>& net) {
  const Eigen::Matrix3Xd mouth = mouth_polygon(structure_, snapshot);
  if (mouth.cols() < 3 || net.empty()) return;
  const Eigen::Vector3d area = vector_area(mouth), middle = mouth.rowwise().mean();
  Eigen::Vector3d net_middle = Eigen::Vector3d::Zero();
  for (const std::int32_t node : net) net_middle += snapshot.positions.col(node) / static_cast<double>(net.size());
  // The tips may be listed in either sense. The net is behind the mouth.
  const double sense = area.dot(middle - net_middle) < 0 ? -1 : 1;
  const Eigen::Vector3d outward = sense * area.normalized();
  escape_depth_ = smaller(escape_depth_, outward.dot(middle - snapshot.bodies[*target_].position));
  const double width = extents(structure_.bodies[*target_].shape).sizes().minCoeff();
  escape_opening_ = larger(escape_opening_, 2 * std::sqrt(area.norm() / std::numbers::pi) / width);
}

double MouthPassage::closed_time() const {
  constexpr double kClosed = 0.95;
  if (lengths_.empty() || !(commanded_ < lengths_.front())) return std::numeric_limits<double>::quiet_NaN();
  const double limit = lengths_.front() + kClosed * (commanded_ - lengths_.front());
  const auto closed = std::ranges::find_if(lengths_, [&](double length) { return length <= limit; });
  if (closed == lengths_.end()) return std::numeric_limits<double>::quiet_NaN();
  return times_[static_cast<std::size_t>(closed - lengths_.begin())];
}

}  // namespace netpocket
