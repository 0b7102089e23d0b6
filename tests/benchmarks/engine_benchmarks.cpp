// Timings of the engine: element forces by evaluation, steps of the pocket by size and threads, contact, recording, the
// whole of case 1. Machines are noisy: compare rows of one run, not runs. Options beside Google Benchmark's:
// --results=FILE writes a table.

#include <benchmark/benchmark.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>
#include <string_view>

#include "engine/ancf/element_batch.h"
#include "engine/ancf/full_batch.h"
#include "engine/ancf/full_element.h"
#include "engine/ancf/mean_strain_element.h"
#include "engine/capture/run.h"
#include "engine/capture/simulation.h"
#include "engine/dynamics/assembly/coordinate_vectors.h"
#include "engine/recording/recorder.h"
#include "engine/scenario/read_scenario.h"
#include "engine/systems/pocket/materials.h"
#include "tests/benchmarks/machine_peak.h"
#include "tests/benchmarks/results_table.h"

namespace netpocket {
namespace {

constexpr double kLength = 0.3;  // m, a typical net element
// Additions, multiplications, divisions of one element in element_kernel.cpp, counted line by line: 76 in kinematics,
// 56 in resist (and 6 more in a pair).
constexpr double kOperationsPerElement = 132;

CableSection net_section() { return cord_material(CordParameters{}).section; }

// A slightly bent and stretched element that moves.
struct State {
  ElementCoordinates q, velocity;
};
State random_state(std::mt19937& generator) {
  std::uniform_real_distribution<double> noise(-1e-3, 1e-3);
  State state;
  state.q << 0, 1, kLength, 1, 0, 0, 0, 0, 0, 0, 0, 0;
  for (double& value : state.q.reshaped()) value += noise(generator);
  for (double& value : state.velocity.reshaped()) value = 100 * noise(generator);
  return state;
}

using benchmark::Counter;

// `elements`: elements times steps of an iteration.
void report(benchmark::State& state, double elements) {
  state.counters["per_element"] =
      Counter(elements * static_cast<double>(state.iterations()), Counter::kIsRate | Counter::kInvert);
}

void machine_peak(benchmark::State& state) {
  constexpr int kRounds = 10000;
  double operations = 0;
  for (auto _ : state) operations += run_peak(kRounds);
  state.counters["flops"] = Counter(operations, Counter::kIsRate);
}
BENCHMARK(machine_peak)->Name("machine/peak")->UseRealTime()->ThreadRange(1, 2);

// What lies in memory, read one after the other; each thread its own.
void machine_read(benchmark::State& state) {
  const std::vector<double> values(std::size_t{1} << 24, 1.0);
  double bytes = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(read_all(values));
    bytes += static_cast<double>(values.size() * sizeof(double));
  }
  state.counters["bytes"] = Counter(bytes, Counter::kIsRate);
}
BENCHMARK(machine_read)->Name("machine/read")->UseRealTime()->ThreadRange(1, 2);

template <typename Element>
void reference_element(benchmark::State& state) {
  std::mt19937 generator(1);
  const State s = random_state(generator);
  const Element element(net_section(), {.length = kLength});
  for (auto _ : state) {
    benchmark::DoNotOptimize(element.internal_force(s.q, s.velocity));
  }
  report(state, 1);
}
BENCHMARK(reference_element<MeanStrainElement>)->Name("element/reference_mean_strain");
BENCHMARK(reference_element<FullElement>)->Name("element/reference_full");

// Chains of elements side by side, as in a panel: neighbours share nodes.
template <bool kFull>
void element_batch(benchmark::State& state) {
  const auto count = static_cast<std::int32_t>(state.range(0));
  const std::int32_t nodes = count + kBlockSize, blocks = count / kBlockSize;
  std::mt19937 generator(1);
  std::vector<BatchElement> elements;
  CoordinateVectors coordinates(2 * nodes), velocities(2 * nodes);
  for (std::int32_t block = 0; block <= blocks; ++block) {
    for (std::int32_t lane = 0; lane < kBlockSize; ++lane) {
      const State s = random_state(generator);
      const std::int32_t node = block * kBlockSize + lane;
      coordinates.set(node, s.q.col(0) + Eigen::Vector3d(block * kLength, 0, 0));
      coordinates.set(nodes + node, s.q.col(1));
      velocities.set(node, s.velocity.col(0));
      velocities.set(nodes + node, s.velocity.col(1));
      if (block == blocks) continue;
      elements.push_back({{node, nodes + node, node + kBlockSize, nodes + node + kBlockSize}, kLength, net_section()});
    }
  }
  const ElementBatch batch(elements);
  const FullBatch full(batch.block_count());
  const CoordinateRows q = coordinates.rows(), v = velocities.rows();
  AlignedVector<double> forces(static_cast<std::size_t>(batch.block_count()) * kForceRows * kBlockSize);
  for (auto _ : state) {
    benchmark::DoNotOptimize(kFull ? full.forces(batch, 0, batch.block_count(), q, v, forces.data())
                                   : batch.forces(0, batch.block_count(), q, v, forces.data()));
    benchmark::ClobberMemory();
  }
  report(state, count);
  state.counters["elements"] = count;
  if (kFull) return;
  state.counters["flops"] =
      Counter(kOperationsPerElement * count * static_cast<double>(state.iterations()), Counter::kIsRate);
}
BENCHMARK(element_batch<false>)->Name("element/kernel")->Arg(1 << 10)->Arg(1 << 13)->Arg(1 << 16)->Arg(1 << 19);
BENCHMARK(element_batch<true>)->Name("element/full_kernel")->Arg(1 << 10)->Arg(1 << 13)->Arg(1 << 16)->Arg(1 << 19);

// Resident memory of this process, bytes.
double resident_bytes() {
  std::ifstream file("/proc/self/statm");
  double total = 0, resident = 0;
  file >> total >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE));
}

Scenario pocket_of(int meshes) {
  Scenario scenario;
  scenario.pocket.mesh_columns = scenario.pocket.mesh_rows = meshes;
  return scenario;
}

void time_steps(benchmark::State& state, const Scenario& scenario, int threads) {
  const double before = resident_bytes();
  Simulation simulation(scenario, {.threads = threads});
  double until = 1 / scenario.output.frame_rate;
  simulation.advance(until);
  const double elements = static_cast<double>(simulation.structure().elements.size());
  const std::int64_t first = simulation.statistics().steps;
  std::vector<double> times;  // s, per element and step
  for (auto _ : state) {
    const std::int64_t before_steps = simulation.statistics().steps;
    const auto begin = std::chrono::steady_clock::now();
    simulation.advance(until += 1 / scenario.output.frame_rate);
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
    times.push_back(time.count() / elements / static_cast<double>(simulation.statistics().steps - before_steps));
  }
  const double steps = static_cast<double>(simulation.statistics().steps - first);
  report(state, elements * steps / static_cast<double>(state.iterations()));
  std::ranges::sort(times);
  state.counters["quiet_per_element"] = times[times.size() / 10];
  state.counters["elements"] = elements;
  state.counters["bytes_per_element"] = (resident_bytes() - before) / elements;
}

// Steps of the default pocket while it closes, before the first contact. An iteration is a stretch of equal steps; in
// the largest pocket a short one.
void step(benchmark::State& state) {
  Scenario scenario = pocket_of(static_cast<int>(state.range(0)));
  scenario.output.frame_rate = state.range(0) < 100 ? 100 : 5000;
  // Short elements of rods, and damped bending of short cords, would set the step.
  scenario.rods.elements_per_side = 1;
  scenario.net.bending_damping = scenario.rope.bending_damping = 0;
  time_steps(state, scenario, static_cast<int>(state.range(1)));
}
// As many iterations whatever the threads: contacts and the shape, and with them the work of a step, change meanwhile.
const bool kStepsRegistered = [] {
  constexpr std::pair<int, int> kMeshesAndIterations[] = {{4, 200}, {10, 100}, {14, 60}, {20, 40},
                                                          {24, 20}, {46, 2},   {144, 1}};
  for (const int threads : {1, 2}) {
    for (const auto& [meshes, iterations] : kMeshesAndIterations) {
      benchmark::RegisterBenchmark("step/meshes_threads", step)
          ->Args({meshes, threads})
          ->Iterations(iterations)
          ->UseRealTime()
          ->Unit(benchmark::kMillisecond);
    }
  }
  return true;
}();

// The same by evaluation: 0 mean-strain, 1 full.
void step_of_evaluation(benchmark::State& state) {
  Scenario scenario = pocket_of(6);
  scenario.output.frame_rate = 1000;
  if (state.range(0) == 1) scenario.solver.evaluation = Evaluation::full;
  time_steps(state, scenario, 1);
}
BENCHMARK(step_of_evaluation)->Name("step/evaluation")->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);

// The same with the target out of reach: what looking for contact costs.
void step_without_target(benchmark::State& state) {
  Scenario scenario = pocket_of(6);
  scenario.target.position = {0, 1000, 0};
  time_steps(state, scenario, 1);
}
void step_with_target(benchmark::State& state) { time_steps(state, pocket_of(6), 1); }
BENCHMARK(step_with_target)->Name("contact/target_near")->Unit(benchmark::kMillisecond);
BENCHMARK(step_without_target)->Name("contact/target_away")->Unit(benchmark::kMillisecond);

void take_snapshot(benchmark::State& state) {
  Simulation simulation(Scenario{});
  simulation.advance(0.1);
  for (auto _ : state) benchmark::DoNotOptimize(simulation.snapshot());
}
BENCHMARK(take_snapshot)->Name("recording/snapshot")->Unit(benchmark::kMillisecond);

std::filesystem::path temporary_recording() {
  return std::filesystem::temp_directory_path() / ("netpocket_benchmark_" + std::to_string(getpid()) + ".h5");
}

void record_frame(benchmark::State& state) {
  Simulation simulation(Scenario{});
  simulation.advance(0.1);
  const Snapshot snapshot = simulation.snapshot();
  const auto path = temporary_recording();
  Recorder recorder(path, {}, simulation.structure(), true);
  for (auto _ : state) recorder.write(snapshot);
  recorder.finish({}, {});
  std::filesystem::remove(path);
}
BENCHMARK(record_frame)->Name("recording/write")->Unit(benchmark::kMillisecond);

double thread_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

Scenario case1() {
  const ScenarioResult result = read_scenario_file(NETPOCKET_SOURCE_DIR "/scenarios/case1.toml");
  if (!result.ok()) throw std::runtime_error("scenarios/case1.toml is not valid");
  return result.scenario;
}

// Case 1 with a recording of 100 frames per simulated second. Counts the stepping thread's processor time: on a quiet
// machine with a second processor for the writer that is the time one waits. The counters are those of the fastest
// iteration: what slows down the others is not the engine.
void capture(benchmark::State& state) {
  double fastest = std::numeric_limits<double>::infinity();
  for (auto _ : state) {
    Scenario scenario = case1();
    scenario.pocket.elements_per_side = static_cast<int>(state.range(0));
    scenario.output.frame_rate = 100;
    const auto path = temporary_recording();
    const double start = thread_seconds();
    const RunResult result = run_to_recording(scenario, path, {.overwrite = true});
    const double seconds = thread_seconds() - start;
    std::filesystem::remove(path);
    if (seconds >= fastest) continue;
    fastest = seconds;
    const RunStatistics& statistics = result.statistics;
    state.counters["x_real_time"] = statistics.simulated_seconds / seconds;
    state.counters["elements"] = statistics.elements;
    state.counters["per_element"] = seconds / (static_cast<double>(statistics.steps) * statistics.elements);
  }
}
BENCHMARK(capture)->Name("case1/elements_per_side")->Arg(1)->Arg(2)->Iterations(5)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace netpocket

int main(int count, char** arguments) {
  constexpr std::string_view kResults = "--results=";
  std::string results;
  int kept = 0;
  for (int i = 0; i < count; ++i) {
    const std::string_view argument = arguments[i];
    if (argument.starts_with(kResults)) {
      results = argument.substr(kResults.size());
    } else {
      arguments[kept++] = arguments[i];
    }
  }
  benchmark::Initialize(&kept, arguments);
  if (benchmark::ReportUnrecognizedArguments(kept, arguments)) return 2;
  netpocket::ResultsTable table;
  benchmark::RunSpecifiedBenchmarks(&table);
  std::printf("%s", table.speed_text().c_str());
  if (results.empty()) return 0;
  try {
    table.write(results);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 5;
  }
}
