#include "engine/sampling/halton_sequence.h"

#include <array>
#include <cmath>

#include "engine/sampling/design.h"
#include "engine/sampling/random.h"

namespace netpocket {
namespace {

constexpr bool is_prime(std::uint64_t number) {
  for (std::uint64_t divisor = 2; divisor * divisor <= number; ++divisor) {
    if (number % divisor == 0) return false;
  }
  return true;
}

constexpr auto kPrimes = [] {
  std::array<std::uint64_t, kMostDimensions> primes{};
  std::uint64_t number = 2;
  for (std::uint64_t& prime : primes) {
    while (!is_prime(number)) ++number;
    prime = number++;
  }
  return primes;
}();

}  // namespace

double radical_inverse(std::uint64_t index, std::uint64_t base) {
  double value = 0;
  double digit_weight = 1;
  for (; index > 0; index /= base) {
    digit_weight /= static_cast<double>(base);
    value += digit_weight * static_cast<double>(index % base);
  }
  return value;
}

std::uint64_t prime(int i) { return kPrimes[static_cast<std::size_t>(i)]; }

double shifted(double number, double shift) {
  const double sum = number + shift;
  return sum - std::floor(sum);
}

double shifted_halton(std::uint64_t index, int axis, std::uint64_t seed) {
  const double shift = random_fraction(seed, 0, static_cast<std::uint32_t>(axis), RandomPurpose::shift);
  return shifted(radical_inverse(index, prime(axis)), shift);
}

}  // namespace netpocket
