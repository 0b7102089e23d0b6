// Meshes as targets: as they refine, they are caught like the body they approach; and what contact remembers between
// steps does not show in the result.

#include <unistd.h>

#include <filesystem>

#include "engine/capture/simulation.h"
#include "engine/scenario/check_scenario.h"
#include "tests/engine/bodies/mesh_samples.h"
#include "tests/engine/dynamics/models.h"
#include "tests/engine/verification_table.h"

namespace netpocket {
namespace {

using namespace test;

class VerificationMesh : public VerificationTest {};

// Impulse (N s) of a cord of 3 m that flies at 1 m/s onto a free body of 2 kg at rest.
Eigen::Vector3d impulse_of_cord(const Shape& shape) {
  CableMaterial cord = net_cord();
  cord.section.axial_damping = 1e-5;
  cord.section.bending_damping = 1e-2;
  Cable cable = straight_cable(cord, {-1.4, 1.05, 0.2}, {1.6, 1.05, 0.2}, 12);
  for (ModelNode& node : cable.model.nodes) node.velocity = {0, -1, 0};
  cable.model.add_body(
      {.name = "target", .shape = shape, .mass = 2, .inertia = 0.8 * Eigen::Matrix3d::Identity(), .state = {}});
  cable.model.contact.friction = 0.4;
  CableSystem system(cable.model);
  advance(system, 0.4, 0.8 * system.stable_step().step);
  EXPECT_FALSE(system.fault());
  return system.contact_impulse(0);
}

TEST_F(VerificationMesh, CordOnSpheresOfTriangles) {
  const Eigen::Vector3d sphere = impulse_of_cord(Sphere{1});
  ASSERT_GT(sphere.norm(), 1e-3);
  for (const auto& [frequency, bound] : {std::pair(8, 2e-2), {32, 5e-3}, {50, 3e-3}}) {
    const Shape mesh = MeshShape{samples::checked_mesh(samples::equal_volume_sphere(1, frequency))};
    const double error = (impulse_of_cord(mesh) - sphere).norm() / sphere.norm();
    expect_below("impulse on a sphere of " + std::to_string(20 * frequency * frequency) +
                     " triangles against the sphere's, relative error",
                 error, bound,
                 "facets tilt the normal by up to h/(2 R), and cords lie on their edges: 1e-2, 3e-3, 2e-3");
  }
}

class MeshFolder {
 public:
  MeshFolder() { std::filesystem::create_directories(path_); }
  ~MeshFolder() { std::filesystem::remove_all(path_); }
  std::string path() const { return path_.string(); }

 private:
  std::filesystem::path path_ =
      std::filesystem::temp_directory_path() / ("netpocket_mesh_target_" + std::to_string(getpid()));
};

// A drifting ball that meets the closing net within two seconds.
Scenario busy_scenario() {
  Scenario scenario;
  scenario.pocket.mesh_columns = scenario.pocket.mesh_rows = 4;
  scenario.target.radius = 4;
  scenario.target.spin = {0.1, 0.3, 0.2};
  scenario.target.velocity = {0.6, -0.2, 0.3};
  scenario.closing.duration = 3;
  scenario.towing.start = 1.5;
  return scenario;
}

Snapshot run(const Scenario& scenario, const std::vector<double>& stops, int threads = 1) {
  EXPECT_EQ(check_scenario(scenario).text(), "");
  Simulation simulation(scenario, {.threads = threads});
  for (const double stop : stops) {
    EXPECT_EQ(simulation.advance(stop).reason, RunReason::finished);
    simulation.snapshot();
  }
  return simulation.snapshot();
}

TEST_F(VerificationMesh, CaptureOfAMeshedBall) {
  const MeshFolder folder;
  samples::write_file(folder.path() + "/ball.stl", samples::binary_stl(samples::equal_volume_sphere(4, 50)));
  Scenario scenario = busy_scenario();
  const Snapshot ball = run(scenario, {2.5});
  scenario.target.shape = TargetShape::mesh;
  scenario.target.mesh_file = "ball.stl";
  scenario.files.folder = folder.path();
  const Snapshot mesh = run(scenario, {2.5});
  const Eigen::Vector3d start = scenario.target.velocity;
  const double change = (ball.bodies[1].velocity - start).norm();
  ASSERT_GT(change, 1e-3) << "no contact so far";
  expect_below("change of velocity of a ball of 50,000 triangles in a net against the sphere's, relative error",
               (mesh.bodies[1].velocity - ball.bodies[1].velocity).norm() / change, 0.05,
               "many contacts at once; each one's facet tilts the normal by up to 1e-2");

  // Cut into pieces, looked at, with two threads: the same bits.
  const Snapshot pieces = run(scenario, {0.1, 0.1234567, 1.99, 2.0001, 2.5}, 2);
  EXPECT_TRUE(mesh.positions == pieces.positions);
  EXPECT_TRUE(mesh.velocities == pieces.velocities);
  EXPECT_EQ(mesh.bodies[1].position, pieces.bodies[1].position);
  EXPECT_EQ(mesh.bodies[1].velocity, pieces.bodies[1].velocity);
}

TEST(Satellite, IsCaughtBySomeOfItsParts) {
  Scenario scenario = busy_scenario();
  scenario.target.shape = TargetShape::satellite;
  scenario.target.size = {2, 2.4, 2};
  const Snapshot end = run(scenario, {3});
  EXPECT_GT((end.bodies[1].velocity - scenario.target.velocity).norm(), 1e-3);
  EXPECT_FALSE(end.contacts.empty());
}

}  // namespace
}  // namespace netpocket
