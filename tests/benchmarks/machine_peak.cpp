#include "tests/benchmarks/machine_peak.h"

#include <benchmark/benchmark.h>

#include <Eigen/Core>

#include "engine/math/instruction_set.h"

namespace netpocket {
namespace {

// Twelve chains hide the latency of three cycles on four ports. Each a variable of its own: compilers keep an array in
// memory.
constexpr int kChains = 12;

template <int kBytes>
[[gnu::always_inline]] inline double rounds(int count) {
  using Vector [[gnu::vector_size(kBytes)]] = double;
  const Vector factor = Vector{} + 0.999999, summand = Vector{} + 1e-6;
  Vector a = Vector{} + 1.0, b = Vector{} + 2.0, c = Vector{} + 3.0, d = Vector{} + 4.0, e = Vector{} + 5.0,
         f = Vector{} + 6.0, g = Vector{} + 7.0, h = Vector{} + 8.0, i = Vector{} + 9.0, j = Vector{} + 10.0,
         k = Vector{} + 11.0, l = Vector{} + 12.0;
  for (int round = 0; round < count; ++round) {
    a = a * factor, b = b * factor, c = c * factor, d = d * factor, e = e * factor, f = f * factor;
    g = g * factor, h = h * factor, i = i * factor, j = j * factor, k = k * factor, l = l * factor;
    a = a + summand, b = b + summand, c = c + summand, d = d + summand, e = e + summand, f = f + summand;
    g = g + summand, h = h + summand, i = i + summand, j = j + summand, k = k + summand, l = l + summand;
    // Neither dropped nor merged.
    asm volatile(""
                 : "+v"(a), "+v"(b), "+v"(c), "+v"(d), "+v"(e), "+v"(f), "+v"(g), "+v"(h), "+v"(i), "+v"(j), "+v"(k),
                   "+v"(l));
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
