// What a target's shape costs: single questions of distance, and a whole capture by shape. Counters: "to_sphere", time
// relative to that with the default target, a sphere, measured in turn in one run.

#include <benchmark/benchmark.h>
#include <fcl/fcl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <random>

#include "engine/capture/simulation.h"
#include "engine/contact/surface_tracker.h"
#include "tests/engine/bodies/mesh_samples.h"

namespace netpocket {
namespace {

using Eigen::Vector3d;

constexpr double kRadius = 4.5;  // m

std::shared_ptr<const TriangleMesh> ball(int triangles) {
  return samples::checked_mesh(
      samples::equal_volume_sphere(kRadius, static_cast<int>(std::lround(std::sqrt(triangles / 20.0)))));
}

// Points within 5 mm of the ball's surface, as those of cords that touch it.
std::vector<Vector3d> touching_points(std::size_t count) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  std::vector<Vector3d> points;
  while (points.size() < count) {
    const Vector3d direction = Vector3d(normal(random), normal(random), normal(random)).normalized();
    points.push_back((kRadius + 0.005 * std::clamp(normal(random), -1.0, 1.0)) * direction);
  }
  return points;
}

void nearest(benchmark::State& state, const Shape& shape) {
  const auto points = touching_points(1000);
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(nearest_surface_point(shape, points[i++ % points.size()]));
}
void nearest_sphere(benchmark::State& state) { nearest(state, Sphere{kRadius}); }
void nearest_mesh(benchmark::State& state) { nearest(state, MeshShape{ball(static_cast<int>(state.range(0)))}); }
BENCHMARK(nearest_sphere)->Name("distance/sphere");
BENCHMARK(nearest_mesh)->Name("distance/mesh")->Arg(500)->Arg(50000)->Arg(500000);

// Points that creep on at 0.1 mm a step, with what the tracker remembers of them.
void nearest_tracked(benchmark::State& state) {
  const Shape shape = MeshShape{ball(static_cast<int>(state.range(0)))};
  auto points = touching_points(1000);
  SurfaceTracker tracker(shape, points.size());
  std::size_t i = 0;
  for (auto _ : state) {
    const std::size_t index = i++ % points.size();
    Vector3d& point = points[index];
    point += 1e-4 * point.cross(Vector3d(1, 2, 3)).normalized();
    double clearance = 0;
    benchmark::DoNotOptimize(tracker.nearest(index, point, 0.01, clearance));
  }
}
BENCHMARK(nearest_tracked)->Name("distance/mesh_tracked")->Arg(500)->Arg(50000)->Arg(500000);

// FCL's tree of oriented boxes and swept spheres, which knows the distance outside only.
void nearest_fcl(benchmark::State& state) {
  const auto mesh = ball(static_cast<int>(state.range(0)));
  auto model = std::make_shared<fcl::BVHModel<fcl::OBBRSSd>>();
  model->beginModel();
  for (const Triangle& t : mesh->triangles())
    model->addTriangle(mesh->vertices()[t[0]], mesh->vertices()[t[1]], mesh->vertices()[t[2]]);
  model->endModel();
  fcl::CollisionObjectd body(model), probe(std::make_shared<fcl::Sphered>(1e-3));
  auto points = touching_points(1000);
  for (Vector3d& point : points) point *= 1.002;  // outside
  std::size_t i = 0;
  for (auto _ : state) {
    probe.setTranslation(points[i++ % points.size()]);
    probe.computeAABB();
    fcl::DistanceResultd result;
    benchmark::DoNotOptimize(fcl::distance(&body, &probe, fcl::DistanceRequestd(), result));
  }
}
BENCHMARK(nearest_fcl)->Name("distance/mesh_fcl")->Arg(500)->Arg(50000);

double cpu_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_utime.tv_sec) + 1e-6 * static_cast<double>(usage.ru_utime.tv_usec);
}

double run_seconds(const Scenario& scenario) {
  const double start = cpu_seconds();
  Simulation simulation(scenario);
  simulation.advance(scenario.output.end_time);
  return cpu_seconds() - start;
}

void capture_mesh(benchmark::State& state) {
  const auto folder =
      std::filesystem::temp_directory_path() / ("netpocket_target_benchmark_" + std::to_string(getpid()));
  std::filesystem::create_directories(folder);
  const int frequency = static_cast<int>(std::lround(std::sqrt(static_cast<double>(state.range(0)) / 20)));
  samples::write_file((folder / "ball.stl").string(),
                      samples::binary_stl(samples::equal_volume_sphere(kRadius, frequency)));
  Scenario sphere, mesh;
  mesh.target.shape = TargetShape::mesh;
  mesh.target.mesh_file = "ball.stl";
  mesh.files.folder = folder.string();
  for (auto _ : state) {
    const double before = run_seconds(sphere), with_mesh = run_seconds(mesh), after = run_seconds(sphere);
    state.counters["to_sphere"] = 2 * with_mesh / (before + after);
    state.SetIterationTime(with_mesh);
  }
  std::filesystem::remove_all(folder);
}
BENCHMARK(capture_mesh)
    ->Name("capture/target_mesh")
    ->Arg(500)
    ->Arg(50000)
    ->Iterations(1)
    ->UseManualTime()
    ->Unit(benchmark::kSecond);

}  // namespace
}  // namespace netpocket
