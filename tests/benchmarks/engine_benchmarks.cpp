// Timings of the engine: element forces by evaluation, steps of the pocket by size, recorded frames, a whole capture.
// Counters: "per_element" (seconds per element and evaluation or step), "x_real_time". Machines are noisy: compare rows
// of one run, not runs.

#include <benchmark/benchmark.h>
#include <unistd.h>

#include <filesystem>
#include <random>

#include "engine/ancf/element_batch.h"
#include "engine/ancf/full_element.h"
#include "engine/ancf/mean_strain_element.h"
#include "engine/dynamics/simulation.h"
#include "engine/dynamics/slot_state.h"
#include "engine/pocket/materials.h"
#include "engine/recording/recorder.h"

namespace netpocket {
namespace {

constexpr double kLength = 0.3;  // m, a typical net element

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

void report(benchmark::State& state, double elements) {
  state.counters["ns_per_element"] = benchmark::Counter(elements * static_cast<double>(state.iterations()) * 1e-9,
                                                        benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

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

void element_batch(benchmark::State& state) {
  const auto count = static_cast<std::int32_t>(state.range(0));
  std::mt19937 generator(1);
  std::vector<BatchElement> elements;
  SlotVectors coordinates(4 * count), velocities(4 * count);
  for (std::int32_t block = 0; block < count / kBlockSize; ++block) {
    for (std::int32_t lane = 0; lane < kBlockSize; ++lane) {
      const State s = random_state(generator);
      BatchElement element{{}, kLength, net_section()};
      for (std::int32_t corner = 0; corner < 4; ++corner) {
        element.slot[corner] = (4 * block + corner) * kBlockSize + lane;
        coordinates.set(element.slot[corner], s.q.col(corner));
        velocities.set(element.slot[corner], s.velocity.col(corner));
      }
      elements.push_back(element);
    }
  }
  const ElementBatch batch(elements);
  AlignedVector<double> forces(static_cast<std::size_t>(batch.block_count()) * kForceRows * kBlockSize);
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        batch.forces(0, batch.block_count(), coordinates.arrays(), velocities.arrays(), forces.data()));
    benchmark::ClobberMemory();
  }
  report(state, count);
}
BENCHMARK(element_batch)->Name("element/batch")->Arg(1 << 10)->Arg(1 << 13)->Arg(1 << 16)->Arg(1 << 19);

// Steps of the default pocket while it closes, before the first contact.
void step(benchmark::State& state) {
  Scenario scenario;
  scenario.pocket.mesh_columns = scenario.pocket.mesh_rows = static_cast<int>(state.range(0));
  Simulation simulation(scenario, {.threads = static_cast<int>(state.range(1))});
  simulation.advance(0.02);
  const double interval = 1 / scenario.output.frame_rate;
  double until = simulation.time();
  const std::int64_t first = simulation.statistics().steps;
  for (auto _ : state) simulation.advance(until += interval);
  const double elements = static_cast<double>(simulation.structure().elements.size());
  const double steps = static_cast<double>(simulation.statistics().steps - first);
  report(state, elements * steps / static_cast<double>(state.iterations()));
  state.counters["elements"] = elements;
}
BENCHMARK(step)
    ->Name("step/mesh_threads")
    ->Args({6, 1})
    ->Args({24, 1})
    ->Args({24, 2})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

void record_frame(benchmark::State& state) {
  Simulation simulation(Scenario{});
  simulation.advance(0.1);
  const Snapshot snapshot = simulation.snapshot();
  const auto path =
      std::filesystem::temp_directory_path() / ("netpocket_benchmark_" + std::to_string(getpid()) + ".h5");
  Recorder recorder(path, {}, simulation.structure(), true);
  for (auto _ : state) recorder.write(snapshot);
  recorder.finish({}, {});
  std::filesystem::remove(path);
}
BENCHMARK(record_frame)->Name("recording/frame")->Unit(benchmark::kMillisecond);

void capture(benchmark::State& state) {
  for (auto _ : state) {
    Scenario scenario;
    scenario.pocket.elements_per_side = static_cast<int>(state.range(0));
    Simulation simulation(scenario);
    simulation.advance(scenario.output.end_time);
    const RunStatistics statistics = simulation.statistics();
    state.counters["x_real_time"] = statistics.simulated_seconds / statistics.wall_seconds;
    state.counters["elements"] = statistics.elements;
    state.counters["per_element"] =
        statistics.wall_seconds / (static_cast<double>(statistics.steps) * statistics.elements);
  }
}
BENCHMARK(capture)
    ->Name("case1/elements_per_side")
    ->Arg(1)
    ->Arg(2)
    ->Iterations(1)
    ->UseRealTime()
    ->Unit(benchmark::kSecond);

}  // namespace
}  // namespace netpocket
