#include "engine/analysis/metrics/net_cover.h"

#include <algorithm>
#include <limits>

namespace netpocket {
namespace {

Eigen::Vector3d nearest_on(const CordSegment& segment, const Eigen::Vector3d& point) {
  const Eigen::Vector3d along = segment.to - segment.from;
  const double squared_length = along.squaredNorm();
  if (!(squared_length > 0)) return segment.from;
  return segment.from + std::clamp(along.dot(point - segment.from) / squared_length, 0.0, 1.0) * along;
}

// Cords in contact may reach below the tangent plane by as much as they press in.
bool lies_above(const CordSegment& segment, const Eigen::Vector3d& point, const Eigen::Vector3d& normal, double reach) {
  const Eigen::Vector3d offset = nearest_on(segment, point) - point;
  return offset.squaredNorm() <= reach * reach && normal.dot(offset) >= -2 * segment.radius;
}

// In the body's axes, so that each piece is turned only once.
std::vector<CordSegment> in_body_axes(const std::vector<CordSegment>& segments, const BodyState& body) {
  std::vector<CordSegment> turned = segments;
  const Eigen::Matrix3d to_body = body.attitude.conjugate().toRotationMatrix();
  for (CordSegment& s : turned) {
    s.from = to_body * (s.from - body.position);
    s.to = to_body * (s.to - body.position);
  }
  return turned;
}

}  // namespace

double covered_share(const std::vector<SurfaceSample>& samples, const BodyState& body,
                     const std::vector<CordSegment>& segments, double reach) {
  if (samples.empty()) return std::numeric_limits<double>::quiet_NaN();
  const std::vector<CordSegment> cords = in_body_axes(segments, body);
  const auto is_covered = [&](const SurfaceSample& sample) {
    return std::ranges::any_of(
        cords, [&](const CordSegment& cord) { return lies_above(cord, sample.point, sample.normal, reach); });
  };
  return static_cast<double>(std::ranges::count_if(samples, is_covered)) / static_cast<double>(samples.size());
}

}  // namespace netpocket
