#include "engine/sampling/random.h"

#include "engine/sampling/normal.h"

namespace netpocket {
namespace {

// Product of two words: upper and lower half.
std::array<std::uint32_t, 2> wide_product(std::uint32_t a, std::uint32_t b) {
  const std::uint64_t product = std::uint64_t{a} * b;
  return {static_cast<std::uint32_t>(product >> 32), static_cast<std::uint32_t>(product)};
}

double fraction_of(const PhiloxCounter& words) {
  constexpr double kStep = 1.0 / (std::uint64_t{1} << 52);
  const std::uint64_t bits = (std::uint64_t{words[0]} << 32 | words[1]) >> 12;
  return (static_cast<double>(bits) + 0.5) * kStep;
}

}  // namespace

PhiloxCounter philox(PhiloxCounter counter, PhiloxKey key) {
  constexpr int kRounds = 10;
  for (int round = 0; round < kRounds; ++round) {
    const auto a = wide_product(0xD2511F53, counter[0]), b = wide_product(0xCD9E8D57, counter[2]);
    counter = {b[0] ^ counter[1] ^ key[0], b[1], a[0] ^ counter[3] ^ key[1], a[1]};
    key = {key[0] + 0x9E3779B9, key[1] + 0xBB67AE85};
  }
  return counter;
}

PhiloxCounter random_words(std::uint64_t seed, std::uint64_t point, std::uint32_t number, RandomPurpose purpose) {
  return philox({number, static_cast<std::uint32_t>(purpose), static_cast<std::uint32_t>(point),
                 static_cast<std::uint32_t>(point >> 32)},
                {static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)});
}

double random_fraction(std::uint64_t seed, std::uint64_t point, std::uint32_t number, RandomPurpose purpose) {
  return fraction_of(random_words(seed, point, number, purpose));
}

RandomSequence::result_type RandomSequence::operator()() {
  return random_words(seed_, point_, next_++, RandomPurpose::sequence)[0];
}

double RandomSequence::fraction() { return random_fraction(seed_, point_, next_++, RandomPurpose::sequence); }

double RandomSequence::normal() { return normal_quantile(fraction()); }

std::uint32_t RandomSequence::below(std::uint32_t count) {
  // Words beyond the last full multiple of `count` would favour small numbers.
  const std::uint32_t excess = (max() % count + 1) % count;
  std::uint32_t word = (*this)();
  while (word > max() - excess) word = (*this)();
  return word % count;
}

}  // namespace netpocket
