// The search for contact of cords with a body and with each other against brute force, at every step of random scenes.

#include <gtest/gtest.h>

#include <map>
#include <random>

#include "engine/bodies/segment_distance.h"
#include "engine/contact/contact_part.h"
#include "engine/dynamics/contact/cord_polyline.h"
#include "tests/engine/bodies/mesh_samples.h"
#include "tests/engine/dynamics/models.h"

namespace netpocket {
namespace {

using namespace test;
using Eigen::Vector3d;

class Scene {
 public:
  explicit Scene(unsigned seed) : generator_(seed) {
    const Shape shape = random_shape();
    ModelBody body{.name = "body",
                   .shape = shape,
                   .mass = std::exp(between(0, 7)),
                   .inertia = Eigen::Matrix3d::Identity(),
                   .state = {}};
    body.inertia *= body.mass;
    body.state.attitude = Eigen::Quaterniond(Eigen::AngleAxisd(between(-3, 3), direction()));
    body.state.velocity = one_in(2) ? Vector3d(Vector3d::Zero()) : Vector3d(between(0, 5) * direction());
    body.state.angular_velocity = one_in(2) ? Vector3d(Vector3d::Zero()) : Vector3d(between(0, 10) * direction());
    model_.add_body(body);
    CableMaterial cord = net_cord();
    cord.radius = one_in(3) ? 0.02 : 0.002;
    material_ = model_.add_material(cord);
    for (int i = 0; i < 3; ++i) add_cord(shape, body.state.attitude.toRotationMatrix());
    model_.contact.cords = true;
    model_.contact.friction = between(0, 1);
  }

  CableSystem system() {
    CableSystem system(model_);
    if (one_in(3)) {
      std::vector<Vector3d> displacements(model_.nodes.size());
      for (Vector3d& displacement : displacements) displacement = between(0, 0.02) * direction();
      system.displace(displacements);
    }
    return system;
  }

  const Model& model() const { return model_; }

 private:
  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(generator_); }
  bool one_in(int count) { return std::uniform_int_distribution<int>(1, count)(generator_) == 1; }
  Vector3d direction() {
    Vector3d v;
    do v = {between(-1, 1), between(-1, 1), between(-1, 1)};
    while (v.norm() > 1 || v.norm() < 0.1);
    return v.normalized();
  }

  Shape random_shape() {
    static const Shape mesh = MeshShape{samples::checked_mesh(samples::torus(1, 0.4, 24, 12))};
    switch (std::uniform_int_distribution<int>(0, 6)(generator_)) {
      case 0:
        return Sphere{between(0.05, 3)};
      case 1:
        return Box{{between(0.1, 3), between(0.1, 3), between(0.1, 3)}};
      case 2:
        return Box{{between(0.5, 3), 0.02, between(0.5, 3)}};
      case 3:
        return Cylinder{between(0.05, 1), between(0.02, 3)};
      case 4:
        return Satellite({{1, 1.4, 1}, 5, 1, 0.8});
      case 5:
        return mesh;
      default:
        return Box{{0.02, 0.02, between(1, 3)}};
    }
  }

  // Some way off the surface, towards which its loads pull it; often over the cord before.
  void add_cord(const Shape& shape, const Eigen::Matrix3d& rotation) {
    if (!one_in(2)) towards_ = direction();
    Vector3d place = bounding_radius(shape) * towards_;
    const SurfacePoint surface = nearest_surface_point(shape, place);
    place += (between(0.002, 0.05) + model_.materials[material_].radius - surface.distance) * surface.normal;
    const Vector3d inward = -(rotation * surface.normal), middle = rotation * place;
    const Vector3d half = between(0.1, 0.6) * direction().cross(inward).normalized();
    const std::int32_t begin = model_.add_node(middle - half), end = model_.add_node(middle + half);
    const std::vector<std::int32_t> elements =
        model_.add_straight_cable(begin, end, 1 + static_cast<int>(one_in(2)), material_, 0, model_.add_thread("cord"));
    const double acceleration = one_in(3) ? 0 : between(0, 1000), speed = one_in(2) ? 0 : between(0, 30);
    for (const std::int32_t element : elements) {
      const ModelElement& e = model_.elements[element];
      for (const std::int32_t node : {e.node1, e.node2}) {
        model_.nodes[node].load += 0.5 * e.length * net_cord().section.mass_per_length * acceleration * inward;
        model_.nodes[node].velocity = speed * (inward + 0.3 * direction());
      }
      for (const std::int32_t gradient : {e.gradient1, e.gradient2}) {
        model_.gradients[gradient].rate =
            one_in(2) ? Vector3d(Vector3d::Zero()) : Vector3d(between(0, 20) * direction());
      }
    }
    if (!one_in(3)) return;
    const double length = 2 * half.norm(), rate = -between(0, 0.5) * length;
    model_.ropes.push_back({elements, {length, rate}});
  }

  std::mt19937 generator_;
  Vector3d towards_ = Vector3d::UnitX();  // where the last cord was put
  Model model_;
  std::int32_t material_ = 0;
};

using Chain = std::array<Vector3d, CordPolyline::kSegments + 1>;

std::vector<Chain> chains(const Model& model, const Snapshot& snapshot) {
  std::vector<double> lengths;
  for (const ModelElement& element : model.elements) lengths.push_back(element.length);
  for (std::size_t rope = 0; rope < model.ropes.size(); ++rope) {
    for (const std::int32_t element : model.ropes[rope].elements) {
      lengths[element] = snapshot.rope_element_length[rope];
    }
  }
  std::vector<Chain> result;
  for (std::size_t i = 0; i < model.elements.size(); ++i) {
    const ModelElement& e = model.elements[i];
    Chain chain;
    for (int v = 0; v <= CordPolyline::kSegments; ++v) {
      const NodalWeights s = shape(2.0 * v / CordPolyline::kSegments - 1, lengths[i]);
      chain[static_cast<std::size_t>(v)] =
          s[0] * snapshot.positions.col(e.node1) + s[1] * snapshot.gradients.col(e.gradient1) +
          s[2] * snapshot.positions.col(e.node2) + s[3] * snapshot.gradients.col(e.gradient2);
    }
    result.push_back(chain);
  }
  return result;
}

std::vector<Chain> chains_of(CableSystem system) {
  Snapshot snapshot;
  system.capture(snapshot);
  return chains(system.model(), snapshot);
}

// The deepest of many points along all cords; where one solid of a satellite ends another may begin, so each counts by
// itself.
double deepest_by_trial(const Model& model, const std::vector<Chain>& chains, const BodyState& body) {
  constexpr int kPoints = 40;  // on a capsule
  const auto parts = contact_parts(model.bodies[0].shape);
  double deepest = 0;
  for (std::size_t i = 0; i < chains.size(); ++i) {
    for (std::size_t s = 0; s + 1 < chains[i].size(); ++s) {
      for (int p = 0; p <= kPoints; ++p) {
        const Vector3d point = chains[i][s] + p / static_cast<double>(kPoints) * (chains[i][s + 1] - chains[i][s]);
        const Vector3d local = body.attitude.conjugate() * (point - body.position);
        for (const ContactPart& part : parts) {
          deepest = std::max(deepest, model.radius_of(static_cast<std::int32_t>(i)) - part.nearest(local).distance);
        }
      }
    }
  }
  return deepest;
}

using ThreadPair = std::pair<std::int32_t, std::int32_t>;

// Deepest overlap of two cords (of the sum of their radii), by all pairs of their capsules.
std::map<ThreadPair, double> overlaps(const Model& model, const std::vector<Chain>& chains) {
  std::map<ThreadPair, double> result;
  for (std::size_t a = 0; a < chains.size(); ++a) {
    for (std::size_t b = a + 1; b < chains.size(); ++b) {
      const ThreadPair threads = {model.elements[a].thread, model.elements[b].thread};
      if (threads.first == threads.second) continue;
      const double reach =
          model.radius_of(static_cast<std::int32_t>(a)) + model.radius_of(static_cast<std::int32_t>(b));
      for (std::size_t i = 0; i + 1 < chains[a].size(); ++i) {
        for (std::size_t j = 0; j + 1 < chains[b].size(); ++j) {
          const Segment one{chains[a][i], chains[a][i + 1]}, other{chains[b][j], chains[b][j + 1]};
          double& deepest = result[threads];
          deepest = std::max(deepest, 1 - closest_points(one, other).distance / reach);
        }
      }
    }
  }
  return result;
}

// Cords that lie in one another as built stand for one that is reeved through the other: they may.
double deepest_overlap(const std::map<ThreadPair, double>& as_built, const std::map<ThreadPair, double>& now) {
  double deepest = 0;
  for (const auto& [threads, overlap] : now) {
    if (as_built.at(threads) <= 0) deepest = std::max(deepest, overlap);
  }
  return deepest;
}

TEST(MissedContact, NothingIsMissedInRandomScenes) {
  constexpr double kTolerance = 2e-5;  // m, between tried points
  int touching = 0, crossing = 0;
  for (unsigned seed = 1; seed <= 1000; ++seed) {
    Scene scene(seed);
    CableSystem system = scene.system();
    const double dt = 0.5 * system.stable_step().step;
    const auto as_built = overlaps(system.model(), chains_of(CableSystem(scene.model())));
    for (int step = 0; step < 60 && !system.fault(); ++step) {
      Snapshot snapshot;
      system.capture(snapshot);
      const std::vector<Chain> now = chains(system.model(), snapshot);
      const double deepest = deepest_by_trial(system.model(), now, snapshot.bodies[0]);
      if (deepest > kTolerance) ++touching;
      ASSERT_GE(system.penetration(), 0.5 * deepest - kTolerance) << "seed " << seed << ", step " << step;
      const double overlap = deepest_overlap(as_built, overlaps(system.model(), now));
      if (overlap > 0) ++crossing;
      ASSERT_GE(system.cord_contacts().overlap, overlap - 1e-9) << "seed " << seed << ", step " << step;
      for (int i = 0; i < 3; ++i) system.step(dt);
    }
  }
  EXPECT_GT(touching, 2000);
  EXPECT_GT(crossing, 500);
}

}  // namespace
}  // namespace netpocket
