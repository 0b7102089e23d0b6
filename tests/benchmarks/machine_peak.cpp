#include "tests/benchmarks/machine_peak.h"

#include <benchmark/benchmark.h>

#include <Eigen/Core>

#include "engine/ancf/instruction_set.h"

namespace netpocket {
namespace {

constexpr int kChains = 12;  // enough to hide the latency of four cycles on two ports

template <int kBytes>
[[gnu::always_inline]] inline double rounds(int count) {
  using Vector [[gnu::vector_size(kBytes)]] = double;
  Vector chain[kChains];
  for (int i = 0; i < kChains; ++i) chain[i] = Vector{} + (1.0 + i);
  const Vector factor = Vector{} + 0.999999, summand = Vector{} + 1e-6;
  for (int round = 0; round < count; ++round) {
    for (Vector& x : chain) x = x * factor;
    for (Vector& x : chain) x = x + summand;
    for (Vector& x : chain) asm volatile("" : "+v"(x));  // neither dropped nor merged
  }
  return 2.0 * kChains * (kBytes / sizeof(double)) * count;
}

[[gnu::target("avx512f")]] double rounds_avx512(int count) { return rounds<64>(count); }
[[gnu::target("avx2")]] double rounds_avx2(int count) { return rounds<32>(count); }
double rounds_baseline(int count) {
  using Vector [[gnu::vector_size(16)]] = double;
  static_assert(sizeof(Vector) == 16);
  return rounds<16>(count);
}

}  // namespace

double run_peak(int count) {
  switch (instruction_set()) {
    case InstructionSet::avx512:
      return rounds_avx512(count);
    case InstructionSet::avx2:
      return rounds_avx2(count);
    case InstructionSet::baseline:
      break;
  }
  return rounds_baseline(count);
}

double read_all(std::span<const double> values) {
  return Eigen::Map<const Eigen::ArrayXd>(values.data(), static_cast<Eigen::Index>(values.size())).sum();
}

}  // namespace netpocket
