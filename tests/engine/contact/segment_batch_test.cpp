// Searches of eight pieces at once give the bits of single searches.

#include "engine/contact/segment_batch.h"

#include <gtest/gtest.h>

#include <cstring>
#include <random>
#include <vector>

#include "tests/engine/bodies/mesh_samples.h"

namespace netpocket {
namespace {

using Eigen::Vector3d;

// As bits: zeros of either sign differ.
template <typename T>
bool are_same(const T& a, const T& b) {
  return std::memcmp(&a, &b, sizeof(T)) == 0;
}
bool are_same(const SegmentPlace& a, const SegmentPlace& b) {
  return are_same(a.t, b.t) && are_same(a.distance, b.distance) && are_same(a.normal, b.normal);
}
bool are_same(const SegmentContact& a, const SegmentContact& b) {
  return are_same(a.distance, b.distance) && a.is_near == b.is_near &&
         (!a.is_near || (are_same(a.nearest, b.nearest) && a.at_ends == b.at_ends && a.slopes == b.slopes));
}

class Pieces {
 public:
  explicit Pieces(unsigned seed) : generator_(seed) {}
  double between(double low, double high) { return low + (high - low) * unit_(generator_); }
  Vector3d in_cube(double half) { return {between(-half, half), between(-half, half), between(-half, half)}; }

  // Near a surface: most touch it within a few millimetres, some cross the whole solid, some lie on planes of symmetry.
  Segment near_surface(const ContactPart& part, int number) {
    const Vector3d way = in_cube(number % 5 == 0 ? 1.5 : 0.15);
    Vector3d middle = part.centre + in_cube(1.5);
    const SurfacePoint surface = part.nearest(middle);
    middle -= (surface.distance - between(-0.004, 0.002)) * surface.normal;
    Segment piece{middle - 0.5 * way, middle + between(0.1, 0.9) * way};
    if (number % 7 == 0) piece.start[number % 3] = piece.end[number % 3] = part.centre[number % 3];
    if (number % 11 == 0) piece.end = piece.start;
    return piece;
  }

 private:
  std::mt19937 generator_;
  std::uniform_real_distribution<double> unit_{0, 1};
};

std::vector<ContactPart> sample_parts() {
  std::vector<ContactPart> parts;
  const Shape mesh = MeshShape{samples::checked_mesh(samples::geodesic_sphere(0.8, 4))};
  for (const double edge_radius : {0.0, 0.03}) {
    for (const Shape& shape : {Shape(Sphere{0.7}), Shape(Box{{0.5, 1.2, 0.8}}), Shape(Box{{0.02, 1, 1}}),
                               Shape(Cylinder{0.4, 1.1}), Shape(Cylinder{0.01, 2}), mesh}) {
      parts.push_back(contact_parts(shape, edge_radius).front());
    }
    for (const ContactPart& part : contact_parts(Satellite({{1, 1.4, 1}, 5, 1, 0.8}), edge_radius)) {
      parts.push_back(part);
    }
  }
  return parts;
}

TEST(SegmentBatch, GivesTheBitsOfSingleSearches) {
  Pieces random(7);
  const double radius = 0.002;
  int searched = 0, deep = 0;
  for (const ContactPart& part : sample_parts()) {
    for (const int count : {1, 7, 8, 9, 400}) {
      const auto n = static_cast<std::size_t>(count);
      std::vector<Segment> pieces;
      for (int i = 0; i < count; ++i) pieces.push_back(random.near_surface(part, i));
      std::vector<SurfacePoint> starts(n), ends(n);
      std::vector<PointTask> points;
      for (std::size_t i = 0; i < n; ++i) {
        points.push_back({&pieces[i].start, &starts[i]});
        points.push_back({&pieces[i].end, &ends[i]});
      }
      find_nearest_points(part, points);
      for (const PointTask& task : points) {
        const SurfacePoint single = part.nearest(*task.point);
        ASSERT_TRUE(are_same(single.distance, task.nearest->distance) && are_same(single.normal, task.nearest->normal))
            << task.point->transpose() << ": " << single.normal.transpose() << ", " << task.nearest->normal.transpose();
      }
      std::vector<SegmentContact> contacts(n);
      std::vector<NearestTask> nearest;
      for (std::size_t i = 0; i < n; ++i) {
        nearest.push_back({pieces[i], {&starts[i], &ends[i]}, random.between(-0.001, 0.004), &contacts[i]});
      }
      find_nearest(part, nearest);
      std::vector<SegmentPlace> places(2 * n);
      std::vector<DeepestTask> deepest;
      for (std::size_t i = 0; i < n; ++i) {
        const SegmentContact single = nearest_on_segment(part, pieces[i], nearest[i].ends, nearest[i].reach);
        ASSERT_TRUE(are_same(single, contacts[i])) << single.distance << " " << contacts[i].distance;
        searched += single.is_near && single.nearest.t > 0 && single.nearest.t < 1 ? 1 : 0;
        if (!single.is_near || !(single.distance < radius)) continue;
        deepest.push_back({pieces[i], &contacts[i], radius, {0, 0.5}, &places[2 * i]});
        deepest.push_back({pieces[i], &contacts[i], radius, {1, 0.5}, &places[2 * i + 1]});
      }
      find_deepest(part, deepest);
      for (const DeepestTask& task : deepest) {
        const SegmentPlace single = find_deepest(part, task.segment, *task.contact, task.radius, task.weight);
        ASSERT_TRUE(are_same(single, *task.result)) << single.t << " " << task.result->t;
        deep += single.t > 0 && single.t < 1 ? 1 : 0;
      }
    }
  }
  EXPECT_GT(searched, 1000);
  EXPECT_GT(deep, 1000);
}

}  // namespace
}  // namespace netpocket
