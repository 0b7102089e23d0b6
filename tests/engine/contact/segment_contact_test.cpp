// Where a piece of a cord meets a solid, against points tried one beside the other.

#include "engine/contact/segment_contact.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/engine/bodies/mesh_samples.h"

namespace netpocket {
namespace {

using Eigen::Vector3d;

SegmentContact nearest(const ContactPart& part, const Segment& segment, double reach) {
  const SurfacePoint start = part.nearest(segment.start), end = part.nearest(segment.end);
  return nearest_on_segment(part, segment, {&start, &end}, reach);
}

class Random {
 public:
  explicit Random(unsigned seed) : generator_(seed) {}
  double between(double low, double high) { return low + (high - low) * unit_(generator_); }
  Vector3d in_cube(double half) { return {between(-half, half), between(-half, half), between(-half, half)}; }

 private:
  std::mt19937 generator_;
  std::uniform_real_distribution<double> unit_{0, 1};
};

std::vector<ContactPart> solids() {
  std::vector<ContactPart> parts;
  const Shape mesh = MeshShape{samples::checked_mesh(samples::geodesic_sphere(0.8, 6))};
  for (const Shape& shape : {Shape(Sphere{0.7}), Shape(Box{{0.5, 1.2, 0.8}}), Shape(Box{{0.02, 1, 1}}),
                             Shape(Cylinder{0.4, 1.1}), Shape(Cylinder{0.01, 2}), mesh}) {
    parts.push_back(contact_parts(shape).front());
  }
  for (const double edge_radius : {0.0, 0.06}) {
    for (const ContactPart& part : contact_parts(Satellite({{1, 1.4, 1}, 5, 1, 0.8}), edge_radius)) {
      parts.push_back(part);
    }
  }
  return parts;
}

// Of many places: none may be nearer.
double nearest_by_trial(const ContactPart& part, const Segment& segment) {
  double least = 1e9;
  for (int i = 0; i <= 4000; ++i) {
    least = std::min(least, part.nearest(segment.start + i / 4000.0 * (segment.end - segment.start)).distance);
  }
  return least;
}

// Beside a face nothing changes. Beside an edge the distance is that of a circle about its axis, also inside.
TEST(ContactPart, RoundEdges) {
  const double radius = 0.1, root = std::sqrt(0.5);
  const ContactPart box = contact_parts(Box{{1, 2, 3}}, radius).front();
  EXPECT_EQ(box.rounding, radius);
  EXPECT_NEAR(box.nearest({0.55, 0.2, 0}).distance, 0.05, 1e-15);
  EXPECT_NEAR(box.nearest({0.45, 0.2, 0}).distance, -0.05, 1e-15);
  const Vector3d axis(0.4, 0.9, 0.3);  // of the round edge
  for (const double from_axis : {0.02, 0.08, 0.1, 0.3}) {
    for (const double angle : {0.1, 0.7, 1.4}) {
      const Vector3d normal(std::cos(angle), std::sin(angle), 0);
      const SurfacePoint found = box.nearest(axis + from_axis * normal);
      EXPECT_NEAR(found.distance, from_axis - radius, 1e-14);
      EXPECT_LT((found.normal - normal).norm(), 1e-13);
    }
  }
  const ContactPart cylinder = contact_parts(Cylinder{0.5, 2}, radius).front();
  const SurfacePoint rim = cylinder.nearest(Vector3d(0.4, 0.9, 0) + 0.05 * Vector3d(root, root, 0));
  EXPECT_NEAR(rim.distance, -0.05, 1e-14);
  EXPECT_LT((rim.normal - Vector3d(root, root, 0)).norm(), 1e-13);
  EXPECT_EQ(contact_parts(Box{{0.02, 1, 1}}, radius).front().rounding, 0.005);
  EXPECT_EQ(contact_parts(Sphere{0.7}, radius).front().rounding, 0);
}

TEST(SegmentContact, NothingOnThePieceIsNearer) {
  Random random(1);
  const auto parts = solids();
  int near = 0;
  for (int i = 0; i < 3000; ++i) {
    const ContactPart& part = parts[static_cast<std::size_t>(i) % parts.size()];
    const Vector3d start = part.centre + random.in_cube(1.2), way = random.in_cube(0.3);
    const Segment segment{start, start + way};
    const double reach = 0.05, least = nearest_by_trial(part, segment);
    const SegmentContact found = nearest(part, segment, reach);
    const double between_trials = way.norm() / 8000;
    // A mesh that has been entered is tried at a few places only.
    const double tolerance = part.is_convex || least > 0 ? 2e-8 : 0.01;
    if (found.is_near) {
      ++near;
      EXPECT_LE(found.distance, least + tolerance);
      EXPECT_GE(found.distance, least - between_trials - 1e-12);
      EXPECT_NEAR(found.nearest.distance, part.nearest(segment.start + found.nearest.t * way).distance, 1e-15);
      EXPECT_NEAR(found.at_ends[0], part.nearest(segment.start).distance, 1e-12);
      EXPECT_NEAR(found.at_ends[1], part.nearest(segment.end).distance, 1e-12);
    } else {
      EXPECT_GT(found.distance, reach);
      EXPECT_LE(found.distance, least + 1e-12) << "a bound that is none";
    }
  }
  EXPECT_GT(near, 150);
}

// A thin bar that lies between the ends of a piece, and between any points one might have tried.
TEST(SegmentContact, FindsWhatLiesBetweenTheEnds) {
  const ContactPart bar = contact_parts(Box{{1e-4, 1, 1e-4}}).front();
  for (double offset = -0.24; offset < 0.25; offset += 0.013) {
    const Segment segment{{offset - 0.25, 0.2, 1.05e-3}, {offset + 0.25, 0.2, 1.05e-3}};
    const SegmentContact found = nearest(bar, segment, 0.002);
    ASSERT_TRUE(found.is_near) << offset;
    EXPECT_NEAR(found.distance, 1e-3, 1e-9);
  }
}

double value(const ContactPart& part, const Segment& segment, double radius, double at_start, double at_end, double t) {
  const double depth = radius - part.nearest(segment.start + t * (segment.end - segment.start)).distance;
  return (at_start + t * (at_end - at_start)) * std::pow(std::max(depth, 0.0), 2.5);
}

// By how much the place chosen falls short of the largest weight * depth^2.5, as a part of it.
double shortfall(const ContactPart& part, const Segment& segment, double radius, double at_start, double at_end) {
  const SegmentContact contact = nearest(part, segment, radius);
  if (!contact.is_near) return 0;
  const SegmentPlace place = find_deepest(part, segment, contact, radius, {at_start, at_end});
  double largest = 0;
  for (int i = 0; i <= 2000; ++i) {
    largest = std::max(largest, value(part, segment, radius, at_start, at_end, i / 2000.0));
  }
  return largest > 0 ? 1 - value(part, segment, radius, at_start, at_end, place.t) / largest : 0;
}

TEST(SegmentContact, WeightedPlaceIsTheDeepest) {
  const double radius = 0.002;
  for (const auto& [at_start, at_end] : {std::pair{1.0, 0.5}, {0.5, 0.0}, {0.0, 0.5}, {0.5, 1.0}}) {
    for (double tilt = -0.02; tilt <= 0.02; tilt += 0.0025) {
      // On a large sphere, an edge of a box, its face.
      const ContactPart sphere = contact_parts(Sphere{5}).front(), box = contact_parts(Box{{1, 1, 1}}).front();
      for (double x = -0.1; x <= 0.1; x += 0.025) {
        const Vector3d way(0.12 * std::cos(tilt), 0.12 * std::sin(tilt), 0);
        const Vector3d middle(x, 5.0015 - x * x / 10, 0);
        EXPECT_LT(shortfall(sphere, {middle - 0.5 * way, middle + 0.5 * way}, radius, at_start, at_end), 2e-3);
        const Vector3d on_edge(x, 0.5 + 0.0007, 0.5 + 0.0007);
        EXPECT_LT(shortfall(box, {on_edge + Vector3d(0, -0.06, 0.06), on_edge + Vector3d(0, 0.06, -0.06)}, radius,
                            at_start, at_end),
                  2e-2);
        const Vector3d on_face(x, 0.5 + 0.001, 0);
        EXPECT_LT(shortfall(box, {on_face - 0.5 * way, on_face + 0.5 * way}, radius, at_start, at_end), 0.06)
            << x << " " << tilt;
      }
    }
  }
}

}  // namespace
}  // namespace netpocket
