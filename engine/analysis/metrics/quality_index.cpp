#include "engine/analysis/metrics/quality_index.h"

#include <cmath>

namespace netpocket {
namespace {

constexpr int kSurfaceSamples = 1000;
constexpr int kVolumeSamples = 1000;

Eigen::Vector3d in_world(const BodyState& body, const Eigen::Vector3d& point) {
  return body.position + body.attitude * point;
}

}  // namespace

TargetGeometry::TargetGeometry(const Shape& shape)
    : volume(netpocket::volume(shape)),
      area(surface_area(shape)),
      characteristic_length(netpocket::characteristic_length(shape)),
      surface_samples(netpocket::surface_samples(shape, kSurfaceSamples)),
      volume_samples(netpocket::volume_samples(shape, kVolumeSamples)) {}

QualityIndex quality_index(const TargetGeometry& target, const BodyState& body, const ConvexHull& hull,
                           const Eigen::Vector3d& net_centre) {
  return {.volume = std::abs(hull.volume - target.volume) / target.volume,
          .surface = std::abs(hull.area - target.area) / target.area,
          .centre = (net_centre - body.position).norm() / target.characteristic_length};
}

ModifiedQualityIndex modified_quality_index(const TargetGeometry& target, const BodyState& body, const ConvexHull& hull,
                                            double mouth_opening) {
  double outside = 0, distance = 0;
  for (const Eigen::Vector3d& point : target.volume_samples) outside += hull.contains(in_world(body, point)) ? 0 : 1;
  for (const SurfaceSample& sample : target.surface_samples) {
    distance += std::abs(hull.signed_distance(in_world(body, sample.point)));
  }
  return {.outside = outside / static_cast<double>(target.volume_samples.size()),
          .distance = distance / static_cast<double>(target.surface_samples.size()) / target.characteristic_length,
          .opening = mouth_opening};
}

}  // namespace netpocket
