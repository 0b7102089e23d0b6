#include "engine/sampling/permutation.h"

#include <bit>

#include "engine/sampling/random.h"

namespace netpocket {
namespace {

// One to one on numbers of 2 * half_bits bits, for whatever the words are.
std::uint64_t feistel(std::uint64_t number, int half_bits, std::uint64_t seed, std::uint32_t axis) {
  constexpr std::uint32_t kRounds = 6;
  const std::uint64_t mask = (std::uint64_t{1} << half_bits) - 1;
  std::uint64_t left = number >> half_bits, right = number & mask;
  for (std::uint32_t round = 0; round < kRounds; ++round) {
    const PhiloxCounter words = random_words(seed, right, axis * kRounds + round, RandomPurpose::permutation);
    const std::uint64_t mixed = left ^ (words[0] & mask);
    left = right;
    right = mixed;
  }
  return left << half_bits | right;
}

}  // namespace

std::uint64_t permuted(std::uint64_t place, std::uint64_t count, std::uint64_t seed, std::uint32_t axis) {
  const auto bits = static_cast<int>(std::bit_width(count - 1));
  const int half_bits = (bits + 1) / 2;
  if (half_bits == 0) return place;
  std::uint64_t number = feistel(place, half_bits, seed, axis);
  while (number >= count) number = feistel(number, half_bits, seed, axis);
  return number;
}

}  // namespace netpocket
